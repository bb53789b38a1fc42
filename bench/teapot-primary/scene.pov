// The picture of scene.txt beside this file, for POV-Ray 3.7. bench/run makes teapot.inc from models/teapot.obj.
//
// There is no light: the surface emits its kd, <0.3, 0.7, 0.3> for a model without materials. Levels are linear, as ours
// are (with File_Gamma=1 on the command line). The frame is right-handed, hence the negative "right".

#version 3.7;

global_settings { assumed_gamma 1 }

camera {
  location <-4.2, -5.6, 4.6>
  sky z
  right -x                     // as wide as it is high,
  angle 46                     // so that the angle across is the upright one
  look_at <0.1, 0, 1.3>
}

#include "teapot.inc"

object {
  Teapot
  pigment { rgb <0.3, 0.7, 0.3> }
  finish { ambient 0 diffuse 0 emission 1 }
}

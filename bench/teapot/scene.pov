// The picture of scene.txt beside this file, for POV-Ray 3.7. bench/run makes teapot.inc from models/teapot.obj.
//
// Our illumination in its words. A model without materials has ka 0.2 (grey), kd <0.3, 0.7, 0.3>, ks 0.2 and
// shininess 5. POV-Ray's ambient light is coloured by the pigment, hence the division. Levels are linear, as ours are
// (with File_Gamma=1 on the command line). The frame is right-handed, hence the negative "right".

#version 3.7;

global_settings {
  assumed_gamma 1
  ambient_light rgb 1
}

camera {
  location <-4.2, -5.6, 4.6>
  sky z
  right -x                     // as wide as it is high,
  angle 46                     // so that the angle across is the upright one
  look_at <0.1, 0, 1.3>
}

light_source { <-8, 2, 7>, rgb 0.6 }

// The far one, along <-1, 2, -2>.
light_source {
  -1e5 * vnormalize(<-1, 2, -2>), rgb 0.4
  parallel
  point_at 0
}

#include "teapot.inc"

object {
  Teapot
  pigment { rgb <0.3, 0.7, 0.3> }
  finish {
    ambient rgb <0.2 / 0.3, 0.2 / 0.7, 0.2 / 0.3>
    diffuse 1
    specular 0.2
    roughness 1 / 5
  }
}

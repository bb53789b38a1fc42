// The picture of scene.txt beside this file, for POV-Ray 3.7.
//
// There is no light: each surface emits its kd times its colour. Levels are
// linear, as ours are (with File_Gamma=1 on the command line). The frame is
// right-handed, hence the negative "right".

#version 3.7;

global_settings { assumed_gamma 1 }

camera {
  location <-5, 0, 2>
  sky z
  right -x                     // as wide as it is high,
  angle 65                     // so that the angle across is the upright one
  look_at <0, 0, 0>
}

#default { finish { ambient 0 diffuse 0 emission 1 } }

// Our rays start 0.1 in front of the eye, where nothing is nearer, and see 100 far.
plane {
  z, 0
  clipped_by { sphere { <-5, 0, 2>, 100.1 } }
  pigment { rgb 0.4 * 0.4 }
}

#macro Cube(Centre, Colour)
  box {
    Centre - 0.5, Centre + 0.5
    pigment { rgb 0.6 * Colour }
  }
#end

Cube(<0, 0, 0>, <0, 0, 1>)
Cube(<0, 2, 2>, <0, 1, 0>)
Cube(<0, -2, 1>, <1, 0, 0>)

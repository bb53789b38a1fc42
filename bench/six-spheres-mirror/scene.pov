// The picture of scene.txt beside this file, for POV-Ray 3.7.
//
// Our illumination in its words: ambient ka, diffuse kd, specular ks with the
// half-way vector and roughness 1 / shininess; highlights are white
// (plasticity 1). Levels are linear, as ours are (with File_Gamma=1 on the
// command line). The frame is right-handed, hence the negative "right".

#version 3.7;

global_settings {
  assumed_gamma 1
  ambient_light rgb 1
  max_trace_level 4
}

camera {
  location <-7, 0, 3>
  sky z
  right -x                     // as wide as it is high,
  angle 50                     // so that the angle across is the upright one
  look_at <0, 0, 0.8>
}

light_source { <-4, -5, 6>, rgb 0.6 }

// The far one, along <1, -1, -2>.
light_source {
  -1e5 * vnormalize(<1, -1, -2>), rgb 0.4
  parallel
  point_at 0
}

#default {
  finish {
    ambient 0.1
    diffuse 0.7
    specular 0.4
    roughness 1 / 50
    reflection { 0.3 }
  }
}

plane { z, 0 pigment { rgb 0.6 } }

sphere { <0, 0, 1>, 1 pigment { rgb <0.9, 0.2, 0.2> } }
sphere { <-1.5, -1.8, 0.6>, 0.6 pigment { rgb <0.2, 0.8, 0.3> } }
sphere { <-1.5, 1.8, 0.6>, 0.6 pigment { rgb <0.2, 0.4, 0.9> } }
sphere { <1.5, -2.8, 0.9>, 0.9 pigment { rgb <0.9, 0.7, 0.2> } }
sphere { <1.5, 2.8, 0.9>, 0.9 pigment { rgb <0.7, 0.3, 0.8> } }
sphere { <-2.8, 0, 0.4>, 0.4 pigment { rgb <0.3, 0.8, 0.8> } }

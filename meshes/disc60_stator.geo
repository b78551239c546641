// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Section of the stator of a disc motor of 60 mm with nine waves and ninety teeth: x is r, y is z, lengths in m.
// z = 0 is the bonded face between metal and piezoceramic, the tooth tops face +z. All dimensions are assumed; the
// base thickness makes the bending wave with nine nodal diameters 40 kHz (phosphor bronze, teeth between slots with
// parallel walls 0.7 mm apart).
//
//   gmsh -2 disc60_stator.geo
//
// The ring is revolved to a full circle; cells of "tooth" end at the slots.

web_inner_radius       = 10.0e-3; // clamped to the hub
ring_inner_radius      = 22.5e-3;
ring_outer_radius      = 30.0e-3;
web_thickness          = 1.0e-3;
base_thickness         = 2.8e-3;
tooth_height           = 2.0e-3;
piezoceramic_thickness = 0.5e-3;

n_web  = 6; // cells along r
n_ring = 4;

// Points: 10 * column + row
z[] = {-piezoceramic_thickness, 0, web_thickness, base_thickness, base_thickness + tooth_height};
For k In {1:2}
  Point(10 + k) = {web_inner_radius, z[k], 0};
EndFor
For k In {0:4}
  Point(20 + k) = {ring_inner_radius, z[k], 0};
  Point(30 + k) = {ring_outer_radius, z[k], 0};
EndFor

// Lines along r: 100 + the point where they begin; along z: 200 + that point
For k In {1:2}
  Line(110 + k) = {10 + k, 20 + k};
  Transfinite Curve{110 + k} = n_web + 1;
EndFor
For k In {0:4}
  Line(120 + k) = {20 + k, 30 + k};
  Transfinite Curve{120 + k} = n_ring + 1;
EndFor
n_z[] = {1, 1, 2, 2};
For k In {0:3}
  For i In {2:3}
    Line(200 + 10 * i + k) = {10 * i + k, 10 * i + k + 1};
    Transfinite Curve{200 + 10 * i + k} = n_z[k] + 1;
  EndFor
EndFor
Line(211) = {11, 12};
Transfinite Curve{211} = n_z[1] + 1;

// Blocks: 300 + their lower left point, counterclockwise
For k In {0:3}
  Curve Loop(320 + k) = {120 + k, 230 + k, -(121 + k), -(220 + k)};
  Plane Surface(320 + k) = {320 + k};
EndFor
Curve Loop(311) = {111, 221, -112, -211};
Plane Surface(311) = {311};
Transfinite Surface "*";
Recombine Surface "*";

Physical Surface("base")         = {311, 321, 322};
Physical Surface("tooth")        = {323};
Physical Surface("piezoceramic") = {320};
Physical Curve("contact")        = {124}; // the tops of the teeth
Physical Curve("clamped")        = {211};

Mesh.MshFileVersion = 4.1;

// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Section of the rotor of a disc motor of 60 mm: x is r, y is z, lengths in m. A ring of aluminium with a friction
// lining below it, on a flexible web with a hub, which is pressed down and driven. The lining touches the teeth at
// z = 0. All dimensions are assumed.
//
//   gmsh -2 disc60_rotor.geo                                   lining and ring share their nodes
//   gmsh -2 -setnumber adhesive_thickness 5e-5 -o bonded.msh disc60_rotor.geo     a layer of adhesive between them

DefineConstant[adhesive_thickness = {0, Name "Thickness of the adhesive, m"}];

hub_inner_radius    = 5.0e-3;
hub_outer_radius    = 9.0e-3;
ring_inner_radius   = 25.0e-3;
lining_inner_radius = 26.0e-3;
lining_outer_radius = 29.0e-3;
ring_outer_radius   = 30.0e-3;
lining_thickness    = 0.5e-3;
ring_thickness      = 3.0e-3;
web_thickness       = 1.0e-3; // its upper face is level with those of ring and hub

n_web = 6; // cells along r
is_bonded = adhesive_thickness > 0;

// Points: 10 * column + row. Rows: lower and upper face of the lining, lower face of the ring, of the web, upper face
ring_face = lining_thickness + adhesive_thickness;
z[] = {0, lining_thickness, ring_face, ring_face + ring_thickness - web_thickness, ring_face + ring_thickness};
r[] = {hub_inner_radius, hub_outer_radius, ring_inner_radius, lining_inner_radius, lining_outer_radius,
       ring_outer_radius};
For i In {0:5}
  For k In {2:4}
    Point(10 * i + k + 100) = {r[i], z[k], 0};
  EndFor
EndFor
For i In {3:4}
  Point(10 * i + 100) = {r[i], z[0], 0};
  If (is_bonded)
    Point(10 * i + 101) = {r[i], z[1], 0};
  EndIf
EndFor
below = is_bonded ? 1 : 2; // the row of the upper face of the lining

// Lines along r: 200 + 10 * column + row; along z: 300 + 10 * column + row
n_r[] = {2, n_web, 1, 2, 1};
For i In {0:4}
  For k In {2:4}
    If (i != 1 || k > 2)
      Line(200 + 10 * i + k) = {100 + 10 * i + k, 110 + 10 * i + k};
      Transfinite Curve{200 + 10 * i + k} = n_r[i] + 1;
    EndIf
  EndFor
EndFor
Line(230) = {130, 140};
Transfinite Curve{230} = n_r[3] + 1;
If (is_bonded)
  Line(231) = {131, 141};
  Transfinite Curve{231} = n_r[3] + 1;
EndIf
n_z[] = {1, 1, 2, 1};
For i In {0:5}
  For k In {2:3}
    Line(300 + 10 * i + k) = {100 + 10 * i + k, 101 + 10 * i + k};
    Transfinite Curve{300 + 10 * i + k} = n_z[k] + 1;
  EndFor
EndFor
For i In {3:4}
  Line(300 + 10 * i) = {100 + 10 * i, 100 + 10 * i + below};
  Transfinite Curve{300 + 10 * i} = n_z[0] + 1;
  If (is_bonded)
    Line(301 + 10 * i) = {101 + 10 * i, 102 + 10 * i};
    Transfinite Curve{301 + 10 * i} = n_z[1] + 1;
  EndIf
EndFor

// Blocks: 400 + 10 * column + row, counterclockwise
metal[] = {};
For i In {0:4}
  For k In {2:3}
    If (i != 1 || k > 2)
      Curve Loop(400 + 10 * i + k) = {200 + 10 * i + k, 310 + 10 * i + k, -(201 + 10 * i + k), -(300 + 10 * i + k)};
      Plane Surface(400 + 10 * i + k) = {400 + 10 * i + k};
      metal[] += {400 + 10 * i + k};
    EndIf
  EndFor
EndFor
Curve Loop(430) = {230, 340, -(230 + below), -330};
Plane Surface(430) = {430};
If (is_bonded)
  Curve Loop(431) = {231, 341, -232, -331};
  Plane Surface(431) = {431};
  Physical Surface("adhesive") = {431};
EndIf
Transfinite Surface "*";
Recombine Surface "*";

Physical Surface("rotor")  = metal[];
Physical Surface("lining") = {430};
Physical Curve("contact")  = {230};      // the lower face of the lining
Physical Curve("pressed")  = {204};      // the upper face of the hub
Physical Curve("driven")   = {302, 303}; // the bore of the hub

Mesh.MshFileVersion = 4.1;

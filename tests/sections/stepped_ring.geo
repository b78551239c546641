// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Section of a free annulus with two thicknesses, without teeth: x is r, y is z, lengths in m. For comparison with
// the frequencies in stepped_ring of sections_calculix.csv.
//
//   gmsh -2 stepped_ring.geo

inner_radius    = 10.0e-3;
step_radius     = 20.0e-3;
outer_radius    = 30.0e-3;
inner_thickness = 2.0e-3;
outer_thickness = 4.0e-3; // the lower faces are level, at z = 0

Point(1) = {inner_radius, 0, 0};
Point(2) = {step_radius, 0, 0};
Point(3) = {outer_radius, 0, 0};
Point(4) = {outer_radius, inner_thickness, 0};
Point(5) = {outer_radius, outer_thickness, 0};
Point(6) = {step_radius, outer_thickness, 0};
Point(7) = {step_radius, inner_thickness, 0};
Point(8) = {inner_radius, inner_thickness, 0};

Line(1) = {1, 2}; Line(2) = {2, 3};
Line(3) = {3, 4}; Line(4) = {4, 5};
Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {7, 8}; Line(8) = {8, 1};
Line(9) = {2, 7}; Line(10) = {7, 4};
Transfinite Curve{1, 2, 5, 7, 10} = 4;
Transfinite Curve{3, 4, 6, 8, 9} = 2;

Curve Loop(1) = {1, 9, 7, 8};   Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, -10, -9}; Plane Surface(2) = {2};
Curve Loop(3) = {10, 4, 5, 6};  Plane Surface(3) = {3};
Transfinite Surface "*";
Recombine Surface "*";

Physical Surface("base") = {1, 2, 3};

Mesh.MshFileVersion = 4.1;

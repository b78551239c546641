// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One sector of the stator of prm/canon_ring.prm, from one slot centre to the next, or its half
// with theta >= 0. Lengths in m, the axis of the ring along z, the tooth's centre at theta = 0.
//
//   gmsh -3 canon_sector.geo                                               the whole sector
//   gmsh -3 -setnumber half 1 -o canon_half_sector.msh canon_sector.geo    half of it
//
// The sector is built of blocks between two radii (i), lines of nearly constant angle (j) and
// heights (k). Their edges are transfinite, so that the cells are hexahedra and the cuts match.

DefineConstant[half = {0, Choices{0, 1}, Name "Half of the sector only"}];

n_teeth                = 90;
inner_radius           = 30.0e-3;
base_outer_radius      = 36.0e-3; // at z = 0
tip_outer_radius       = 34.2e-3; // at the tooth tops
base_thickness         = 4.37e-3;
tooth_height           = 2.0e-3;
slot_width             = 0.6e-3;
piezoceramic_thickness = 0.5e-3;

// Cells of the blocks. Towards the slot root each cell is thinner than the next by this factor.
factor   = 4;
n_radial = 3;
n_slot   = 2; // from a cut to the wall of the slot
n_tooth  = 3; // from the wall of the slot to the tooth's centre
n_base   = 4;
n_height = 4; // from the slot root to the tooth top

// The line j lies at side * (half a pitch, less the angle of half a slot if it is a wall). As a
// slot's walls are parallel, that angle depends on the radius.
side[]         = {-1, -1, 0, 1, 1};
is_wall[]      = {0, 1, 0, 1, 0};
n_theta[]      = {n_slot, n_tooth, n_tooth, n_slot};
growth_theta[] = {1 / factor, factor, 1 / factor, factor};
z[]            = {-piezoceramic_thickness, 0, base_thickness, base_thickness + tooth_height};
n_z[]          = {1, n_base, n_height};
growth_z[]     = {1, 1 / factor, factor};
id_of_layer[]  = {3, 1, 2}; // piezoceramic, base, tooth

// Numbers of points, lines, surfaces and volumes: one of these + 100 i + 10 k + j.
on_axis  = 100;  point_at      = 1000;
along_r  = 2000; along_theta   = 3000; along_z  = 4000;
normal_r = 5000; normal_theta  = 6000; normal_z = 7000;
block    = 8000;

blocks_1[] = {}; blocks_2[] = {}; blocks_3[] = {}; // by physical id

first = half ? 2 : 0; // line j where the mesh begins
For k In {0:3}
  axis = on_axis + k;
  Point(axis) = {0, 0, z[k]};
  // Between the slots' bottom and the tooth tops there are only the blocks of the tooth.
  low  = k == 3 ? (half ? 2 : 1) : first;
  high = k == 3 ? 3 : 4;
  taper = (z[k] > 0) ? z[k] / (base_thickness + tooth_height) : 0;
  For j In {low:high}
    For i In {0:1}
      r = i ? base_outer_radius + taper * (tip_outer_radius - base_outer_radius) : inner_radius;
      theta = side[j] * (Pi / n_teeth - is_wall[j] * Asin(0.5 * slot_width / r));
      Point(point_at + 100 * i + 10 * k + j) = {r * Cos(theta), r * Sin(theta), z[k]};
      If(j > low)
        at = 100 * i + 10 * k + j - 1;
        Circle(along_theta + at) = {point_at + at, axis, point_at + at + 1};
        Transfinite Curve{along_theta + at} = n_theta[j - 1] + 1 Using Progression growth_theta[j - 1];
      EndIf
      If(k > 0)
        at = 100 * i + 10 * (k - 1) + j;
        Line(along_z + at) = {point_at + at, point_at + at + 10};
        Transfinite Curve{along_z + at} = n_z[k - 1] + 1 Using Progression growth_z[k - 1];
      EndIf
    EndFor
    at = 10 * k + j;
    Line(along_r + at) = {point_at + at, point_at + at + 100};
    Transfinite Curve{along_r + at} = n_radial + 1;
    If(j > low)
      at = 10 * k + j - 1;
      Curve Loop(normal_z + at) = {along_r + at, along_theta + at + 100, -(along_r + at + 1), -(along_theta + at)};
      Surface(normal_z + at) = {normal_z + at};
    EndIf
    If(k > 0)
      at = 10 * (k - 1) + j;
      Curve Loop(normal_theta + at) = {along_r + at, along_z + at + 100, -(along_r + at + 10), -(along_z + at)};
      Surface(normal_theta + at) = {normal_theta + at};
    EndIf
    If(k > 0 && j > low)
      at = 10 * (k - 1) + j - 1;
      For i In {0:1}
        Curve Loop(normal_r + at + 100 * i) = {along_theta + at + 100 * i, along_z + at + 1 + 100 * i,
                                               -(along_theta + at + 10 + 100 * i), -(along_z + at + 100 * i)};
        Surface(normal_r + at + 100 * i) = {normal_r + at + 100 * i};
      EndFor
      Surface Loop(block + at) = {normal_r + at, normal_r + at + 100, normal_theta + at, normal_theta + at + 1,
                                  normal_z + at, normal_z + at + 10};
      Volume(block + at) = {block + at};
      blocks~{id_of_layer[k - 1]}[] += block + at;
    EndIf
  EndFor
EndFor
Transfinite Surface "*";
Recombine Surface "*";
Transfinite Volume "*";

// The ids of include/ringmotor/mesh/ids.h; surfaces without an id are free.
For material In {1:3}
  Physical Volume(material) = blocks~{material}[];
EndFor
If(half)
  Physical Surface(11) = {normal_theta + 2, normal_theta + 12, normal_theta + 22}; // mirror plane
  Physical Surface(12) = {normal_theta + 4, normal_theta + 14};                    // cut
  Physical Surface(15) = {normal_z + 32};                                          // tooth top
Else
  Physical Surface(13) = {normal_theta, normal_theta + 10};     // cut at smaller theta
  Physical Surface(14) = {normal_theta + 4, normal_theta + 14}; // cut at larger theta
  Physical Surface(15) = {normal_z + 31, normal_z + 32};        // tooth top
EndIf

Mesh.MshFileVersion = 4.1;

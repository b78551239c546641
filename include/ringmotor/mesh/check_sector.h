// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/mesh/sector_mesh.h>

namespace ringmotor
{
  /**
   * Looks for mistakes in the cells of a body that was read from @p file: lengths that are not in
   * m, a body that touches the axis, and cells that are inverted.
   *
   * @throws UserError naming the file and the place in the mesh.
   */
  void check_cells(const dealii::Triangulation<3> &triangulation, const MeshFile &file);

  /** Looks for a body in pieces, or in parts that touch without sharing nodes. @throws UserError */
  void check_connections(const dealii::Triangulation<3> &triangulation, const MeshFile &file);

  /**
   * Looks for mistakes in a sector that was read: cuts that do not match under a rotation by
   * 2 pi/n_sectors or are not fully marked, and cells beyond the cuts.
   *
   * @throws UserError naming the file and the place in the mesh.
   */
  void check_cuts(const SectorMesh &mesh, const MeshFile &file);

  /**
   * Looks for mistakes in what the ids of a sector say: a tooth's top that is not level, not at the
   * highest z, not on the tooth, marked in part, or not a face between an inner and an outer side
   * and two ends with its middle at theta = 0; a tooth that does not stand on the base at the
   * slot's bottom; a ceramic ring that is not bonded at z = 0. The cuts have to be right.
   *
   * @throws UserError naming `Stator/Mesh file` and the place in the mesh.
   */
  void check_tooth(const SectorMesh &mesh, const MeshFile &file);

  /**
   * Looks for mistakes in a rotor's face in contact, if it has one: it is level and faces -z.
   *
   * @throws UserError naming `Rotor/Mesh file` and the place in the mesh.
   */
  void check_lip(const SectorMesh &mesh, const MeshFile &file);

  /**
   * Moves the nodes of a sector that has passed these checks to where they are meant to be, by
   * places::file_rounding at most: to the planes theta = 0 and of the cuts, to the heights and
   * radii of the faces in contact and of the tooth's foot, and to both faces of the ceramic ring.
   */
  void move_to_exact_places(SectorMesh &mesh);
} // namespace ringmotor

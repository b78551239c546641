// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/condensation.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** A node of a potential contact surface. */
  struct SurfaceNode
  {
    dealii::Point<2> place;                 ///< (r, theta) in m and rad
    std::array<LinearForm, 3> displacement; ///< normal (z), along -theta, radial; see PointVector
  };

  /**
   * One sector of a potential contact surface, as quadrilaterals in the plane (r, theta), over
   * which displacements are polynomials of the same degree in each direction.
   */
  struct ContactSurface
  {
    unsigned int degree = 0;
    std::vector<SurfaceNode> nodes;
    /** The nodes of a face in the order of FE_Q<2>(degree) on the face's cell of `plane`. */
    std::vector<std::vector<unsigned int>> faces;
    std::vector<std::array<dealii::Point<2>, 4>> corners; ///< of each face, as deal.II orders them
  };

  /** Where a point lies in a quadrilateral that is nearly a parallelogram, in unit coordinates. */
  dealii::Point<2> unit_point(const std::array<dealii::Point<2>, 4> &corner,
                              const dealii::Point<2> &x);

  /** Nodes of a surface and their weights. */
  using SurfaceWeights = std::vector<std::pair<unsigned int, double>>;

  /** Those that interpolate a field to a @p place (r, theta), or to the nearest point of the
   * surface. */
  SurfaceWeights interpolation(const ContactSurface &surface, const dealii::Point<2> &place);

  /** The faces of solids with this boundary id, in the meshed part of the sector.
   * @throws UserError if a face is too far from a parallelogram in the plane (r, theta) */
  ContactSurface solid_surface(const SectorElements &sector,
                               const dealii::types::boundary_id faces);

  /** The lower face of the shell's cells with this material id. */
  ContactSurface shell_surface(const SectorElements &sector,
                               const dealii::types::material_id cells);

  /** Where a node of a whole sector's surface comes from. */
  struct MirroredNode
  {
    unsigned int node; ///< of the half surface
    bool mirrored;     ///< at -theta, where U(-theta) = S conj(U(theta))
  };

  /** A surface over a whole sector, and where its nodes come from. */
  struct SectorSurface
  {
    ContactSurface surface; ///< without displacement forms
    std::vector<MirroredNode> origin;
  };

  /** The surface over the whole sector: that of a half sector is completed by its mirror image. */
  SectorSurface whole_surface(const ContactSurface &meshed, const SectorForm form);

  /** All displacement forms of a surface, three for each node. */
  std::vector<LinearForm> displacement_forms(const ContactSurface &surface);
} // namespace ringmotor

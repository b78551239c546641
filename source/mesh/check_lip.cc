// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>

#include <algorithm>
#include <limits>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  void check_lip(const SectorMesh &mesh, const MeshFile &file)
  {
    const double outer_radius = range_of_radii(*mesh.triangulation).second;
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == ids::lip)
        {
          Tensor<1, 3> outwards = cross_product_3d(face->vertex(3) - face->vertex(0),
                                                   face->vertex(2) - face->vertex(1));
          if (outwards * (face->center() - cell->center()) < 0.)
            outwards *= -1.;
          if (outwards[2] > -0.5 * outwards.norm())
            file.refuse("the surface 'contact' does not face the stator, near " +
                            in_words(cylindrical(face->center())),
                        "name the lower face of lip or lining, which faces -z");
          for (const unsigned int i : face->vertex_indices())
          {
            low  = std::min(low, face->vertex(i)[2]);
            high = std::max(high, face->vertex(i)[2]);
          }
        }
    if (high - low > places::file_rounding * outer_radius)
      file.refuse_place((high - low) / outer_radius,
                        "the surface 'contact' reaches from z = " + in_millimetres(low) + " to " +
                            in_millimetres(high),
                        "in a mesh of a sector it must be level; draw a crowned or conical face as "
                        "a section (Rotor/Section file)");
  }
} // namespace ringmotor

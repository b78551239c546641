// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/manifold_lib.h>

#include <fstream>
#include <set>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    [[noreturn]] void refuse(const std::string &file, const std::string &found,
                             const std::string &what_to_do)
    {
      throw UserError("Stator/Mesh file: " + file + ": " + found + "; " + what_to_do);
    }

    void read(const std::string &file, Triangulation<3> &triangulation)
    {
      std::ifstream input(file);
      if (!input)
        refuse(file, "the file cannot be opened",
               "check the name, it is looked for beside the parameter file");
      GridIn<3> reader(triangulation);
      try
      {
        reader.read_msh(input);
      }
      catch (const ExceptionBase &error)
      {
        std::ostringstream reason;
        error.print_info(reason);
        std::string text = reason.str();
        for (char &c : text)
          c = c == '\n' ? ' ' : c;
        refuse(
            file, "not a mesh of hexahedra in Gmsh's format (" + text.substr(0, 200) + ")",
            "save hexahedra (recombined, first order) as version 2.2 or 4.1, see meshes/README.md");
      }
    }

    void check_ids(const std::string &file, const Triangulation<3> &triangulation)
    {
      const std::set<types::material_id> materials{ids::base, ids::tooth, ids::piezoceramic};
      const std::set<types::boundary_id> boundaries{ids::free,    ids::mirror,   ids::cut,
                                                    ids::cut_low, ids::cut_high, ids::tooth_top};
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        if (materials.count(cell->material_id()) == 0)
          refuse(file, "a volume has the physical id " + std::to_string(cell->material_id()),
                 "allowed are 1 (base), 2 (tooth) and 3 (piezoceramic)");
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && boundaries.count(face->boundary_id()) == 0)
            refuse(file, "a surface has the physical id " + std::to_string(face->boundary_id()),
                   "allowed are 11 (mirror plane), 12 (cut), 13 and 14 (cuts), 15 (tooth top), or "
                   "none");
      }
    }

    SectorForm form_of(const std::string &file, const Triangulation<3> &triangulation)
    {
      std::set<types::boundary_id> found;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            found.insert(face->boundary_id());
      const bool half  = found.count(ids::mirror) && found.count(ids::cut);
      const bool whole = found.count(ids::cut_low) && found.count(ids::cut_high);
      if (half == whole)
        refuse(file,
               half ? "it has the surfaces of a half and of a whole sector"
                    : "the cuts are not marked",
               "mark either 11 (mirror plane theta = 0) and 12 (cut), or 13 and 14 (the two cuts), "
               "as physical surfaces");
      return half ? SectorForm::half : SectorForm::whole;
    }

    void check_cells(const std::string &file, const Triangulation<3> &triangulation)
    {
      const MappingQ<3> mapping(2);
      const FE_Nothing<3> nothing;
      for (const auto &cell : triangulation.active_cell_iterators())
        try
        {
          // The Jacobian must be positive at the corners too, where it is worst.
          for (const Quadrature<3> &points : {static_cast<Quadrature<3>>(QGauss<3>(3)),
                                              static_cast<Quadrature<3>>(QTrapezoid<3>())})
          {
            FEValues<3> values(mapping, nothing, points, update_JxW_values);
            values.reinit(cell);
            for (const double jacobian : values.get_JxW_values())
              if (!(jacobian > 0.))
                throw ComputationError("inverted");
          }
        }
        catch (const std::exception &)
        {
          const Point<3> center = cell->center();
          std::ostringstream where;
          where << 1e3 * center;
          refuse(file, "the cell at (" + where.str() + ") mm is inverted or degenerate",
                 "repair the mesh");
        }
    }
  } // namespace

  SectorMesh read_sector(const std::string &file, const unsigned int n_sectors,
                         MPI_Comm communicator)
  {
    SectorMesh mesh{empty_triangulation(communicator), SectorForm::half, n_sectors};
    Triangulation<3> &triangulation = *mesh.triangulation;
    read(file, triangulation);
    check_ids(file, triangulation);
    mesh.form = form_of(file, triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    check_cells(file, triangulation);
    return mesh;
  }
} // namespace ringmotor

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_gmsh.h>
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_sector.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Lets deal.II read the file, and rewords its errors. */
    void read(const std::string &file, Triangulation<3> &triangulation)
    {
      std::ifstream input(file);
      if (!input)
        throw mesh_file_error(file, "it cannot be opened", "check the name and the permissions");
      const UserError damaged = mesh_file_error(
          file, "it is damaged, or not a mesh in Gmsh's ASCII format of version 2.2 or 4.1",
          "save it again as such, with hexahedra of first order (meshes/README.md)");
      if (!is_whole_gmsh(input))
        throw damaged;
      input.clear();
      input.seekg(0);
      // deal.II does not check whether there was a number to read: without exceptions, a file that
      // ends early would make it loop forever.
      input.exceptions(std::ios::failbit | std::ios::badbit);
      GridIn<3> reader(triangulation);
      try
      {
        reader.read_msh(input);
      }
      catch (const std::ios::failure &)
      {
        throw damaged;
      }
      catch (const GridIn<3>::ExcInvalidGMSHInput &)
      {
        throw damaged;
      }
      catch (const GridIn<3>::ExcInvalidVertexIndexGmsh &)
      {
        throw damaged;
      }
      catch (const GridIn<3>::ExcGmshUnsupportedGeometry &)
      {
        throw mesh_file_error(file, "it has elements that are not hexahedra of first order",
                              "recombine the mesh and do not raise its order");
      }
      catch (const GridIn<3>::ExcGmshNoCellInformation &)
      {
        throw mesh_file_error(file, "it has no volume elements",
                              "mark the volumes as physical volumes 1 (base), 2 (tooth), 3 "
                              "(piezoceramic) and mesh in three dimensions");
      }
      catch (const ExceptionBase &)
      {
        throw mesh_file_error(file,
                              "a physical surface lies inside the body, cells lie on one another, "
                              "or a volume or surface has two physical ids",
                              "mark outer surfaces only, each with one id, and do not set "
                              "Mesh.SaveAll");
      }
    }

    void check_cells(const std::string &file, const Triangulation<3> &triangulation)
    {
      if (!triangulation.all_reference_cells_are_hyper_cube())
        throw mesh_file_error(file, "it has tetrahedra, prisms or pyramids",
                              "make hexahedra only (Gmsh: Transfinite and Recombine)");
      const std::set<types::material_id> allowed{ids::base, ids::tooth, ids::piezoceramic};
      for (const auto &cell : triangulation.active_cell_iterators())
        if (allowed.count(cell->material_id()) == 0)
          throw mesh_file_error(file,
                                "a volume has the physical id " +
                                    std::to_string(static_cast<int>(cell->material_id())),
                                "allowed are 1 (base), 2 (tooth) and 3 (piezoceramic)");
    }

    SectorForm form_of(const std::string &file, const Triangulation<3> &triangulation)
    {
      const std::set<types::boundary_id> allowed{ids::free,    ids::mirror,   ids::cut,
                                                 ids::cut_low, ids::cut_high, ids::tooth_top};
      const std::vector<types::boundary_id> found = triangulation.get_boundary_ids();
      for (const types::boundary_id id : found)
        if (allowed.count(id) == 0)
          throw mesh_file_error(file, "a surface has the physical id " + std::to_string(id),
                                "allowed are 11 (mirror plane), 12 (cut), 13 and 14 (cuts), 15 "
                                "(tooth top), or none");
      const auto marked = [&](const types::boundary_id id)
      { return std::count(found.begin(), found.end(), id) > 0; };
      const bool half  = marked(ids::mirror) && marked(ids::cut);
      const bool whole = marked(ids::cut_low) && marked(ids::cut_high);
      const bool mixed = half ? marked(ids::cut_low) || marked(ids::cut_high)
                              : marked(ids::mirror) || marked(ids::cut);
      if ((!half && !whole) || mixed)
        throw mesh_file_error(
            file,
            half || whole ? "it has the surfaces of a half and of a whole sector"
                          : "the cuts are not marked",
            "mark either 11 (mirror plane theta = 0) and 12 (cut), or 13 and 14 (the two cuts), as "
            "physical surfaces");
      return half ? SectorForm::half : SectorForm::whole;
    }
  } // namespace

  SectorMesh read_sector(const std::string &file, const unsigned int n_sectors,
                         MPI_Comm communicator)
  {
    SectorMesh mesh{empty_triangulation<3>(communicator), SectorForm::half, n_sectors};
    Triangulation<3> &triangulation = *mesh.triangulation;
    read(file, triangulation);
    check_cells(file, triangulation);
    mesh.form = form_of(file, triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    check_sector(mesh, file);
    return mesh;
  }
} // namespace ringmotor

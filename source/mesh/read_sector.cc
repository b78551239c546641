// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_sector.h>
#include <ringmotor/mesh/gmsh_mesh.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/mesh/sector_ids.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    std::string name_of(const long kind)
    {
      static const std::map<long, std::string> names{{GmshMesh::triangle, "triangles"},
                                                     {GmshMesh::tetrahedron, "tetrahedra"},
                                                     {GmshMesh::prism, "prisms"},
                                                     {GmshMesh::pyramid, "pyramids"}};
      const auto found              = names.find(kind);
      const bool is_of_second_order = kind >= 8 && kind <= 19;
      return found != names.end() ? found->second
             : is_of_second_order ? "elements of second order"
                                  : "Gmsh's kind " + std::to_string(kind);
    }

    /** @throws UserError for other elements than hexahedra and their faces */
    void check_kinds(const GmshMesh &mesh, const BodyOf body)
    {
      for (const GmshMesh::Element &element : mesh.elements)
      {
        if (element.kind == GmshMesh::line)
          continue;
        const bool is_free_triangle = element.kind == GmshMesh::triangle && element.id == ids::free;
        if (element.kind != GmshMesh::hexahedron && element.kind != GmshMesh::quadrilateral &&
            !is_free_triangle)
          mesh.file.refuse("it has elements that are not hexahedra of first order: " +
                               name_of(element.kind),
                           "recombine the mesh (Gmsh: Transfinite or Extrude, with Recombine, in "
                           "each volume) and do not raise its order");
      }
      if (std::none_of(mesh.elements.begin(), mesh.elements.end(), is_volume))
        mesh.file.refuse("it has no volume elements",
                         (body == BodyOf::stator ? "mark the volumes as physical volumes "
                                                 : "give the volumes physical ") +
                             volumes_of(body) + " and mesh in three dimensions");
    }

    /** The cells of a file, and the surfaces that it marks. */
    class MeshOfFile
    {
    public:
      /** @param mesh with our own ids @throws UserError for cells that cannot be those of a body */
      MeshOfFile(const GmshMesh &mesh, const BodyOf body);

      void create(Triangulation<3> &triangulation);
      /** Gives faces their ids. @throws UserError for surfaces that are not outer ones */
      void mark(Triangulation<3> &triangulation) const;

    private:
      using Element = GmshMesh::Element;
      using Nodes   = std::vector<unsigned int>;

      void add_cell(const Element &element);
      void expect_volume(const CellData<3> &cell) const;
      std::string near(const Nodes &nodes) const { return near_nodes(mesh, nodes); }
      /** Gmsh may mark what lies between partitions. */
      std::string or_without_partitions() const
      {
        return mesh.has_partitions ? "; or save the mesh without partitions" : "";
      }

      const GmshMesh &mesh;
      const BodyOf body;
      std::vector<CellData<3>> cells;
      std::vector<Point<3>> vertices;
      std::vector<unsigned int> vertex_of_node;
      std::map<Nodes, long> ids_of_cells;            ///< by ascending nodes
      std::map<Nodes, unsigned int> n_cells_at_face; ///< by ascending nodes
    };

    MeshOfFile::MeshOfFile(const GmshMesh &mesh, const BodyOf body)
        : mesh(mesh), body(body), vertex_of_node(mesh.nodes.size(), numbers::invalid_unsigned_int)
    {
      for (const Element &element : mesh.elements)
        if (is_volume(element))
          add_cell(element);
    }

    std::vector<unsigned int> sorted(std::vector<unsigned int> nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }

    void MeshOfFile::add_cell(const Element &element)
    {
      Nodes nodes(8);
      for (unsigned int i = 0; i < 8; ++i)
        nodes[GeometryInfo<3>::ucd_to_deal[i]] = element.nodes[i];
      const Nodes key = sorted(nodes);
      if (std::adjacent_find(key.begin(), key.end()) != key.end())
        mesh.file.refuse("a cell has a node twice, so that it has no volume" + near(nodes),
                         "repair the mesh");
      const auto [known, is_new] = ids_of_cells.emplace(key, element.id);
      if (!is_new && known->second != element.id)
        mesh.file.refuse("a volume has the physical ids " + std::to_string(known->second) +
                             " and " + std::to_string(element.id) + near(nodes),
                         "give each volume one physical id only");
      bool is_alone = is_new;
      for (const unsigned int face : GeometryInfo<3>::face_indices())
      {
        Nodes of_face;
        for (unsigned int i = 0; i < 4; ++i)
          of_face.push_back(nodes[GeometryInfo<3>::face_to_cell_vertices(face, i)]);
        is_alone = ++n_cells_at_face[sorted(of_face)] <= 2 && is_alone;
      }
      if (!is_alone)
        mesh.file.refuse("cells lie on one another: more than two cells meet at one face" +
                             near(nodes),
                         "save each cell once, and give each volume one physical id only");

      cells.emplace_back();
      cells.back().material_id = element.id;
      for (unsigned int i = 0; i < 8; ++i)
      {
        unsigned int &vertex = vertex_of_node[nodes[i]];
        if (vertex == numbers::invalid_unsigned_int)
        {
          vertex = vertices.size();
          vertices.push_back(mesh.nodes[nodes[i]]);
        }
        cells.back().vertices[i] = vertex;
      }
    }

    /** deal.II cannot turn round what has no volume. */
    void MeshOfFile::expect_volume(const CellData<3> &cell) const
    {
      constexpr double flat = 1e-12;
      Point<3> center;
      double shortest = std::numeric_limits<double>::max(), longest = 0., radius = 0.;
      for (const unsigned int a : cell.vertices)
      {
        center += 0.125 * vertices[a];
        radius = std::max(radius, cylindrical(vertices[a])[0]);
        for (const unsigned int b : cell.vertices)
          if (a != b)
          {
            shortest = std::min(shortest, vertices[a].distance(vertices[b]));
            longest  = std::max(longest, vertices[a].distance(vertices[b]));
          }
      }
      const double volume = GridTools::cell_measure<3>(vertices, cell.vertices);
      if (!(std::abs(volume) > flat * std::pow(longest, 3)))
        mesh.file.refuse_place(shortest / radius,
                               "the cell at " + in_words(cylindrical(center)) +
                                   " is inverted or has no volume",
                               "repair the mesh");
    }

    void MeshOfFile::create(Triangulation<3> &triangulation)
    {
      for (const CellData<3> &cell : cells)
        expect_volume(cell);
      GridTools::invert_cells_with_negative_measure(vertices, cells);
      GridTools::consistently_order_cells(cells);
      triangulation.create_triangulation(vertices, cells, SubCellData());
    }

    void MeshOfFile::mark(Triangulation<3> &triangulation) const
    {
      std::map<Nodes, Triangulation<3>::face_iterator> faces; // by ascending vertices
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
        {
          Nodes of_face;
          for (const unsigned int i : face->vertex_indices())
            of_face.push_back(face->vertex_index(i));
          faces[sorted(of_face)] = face;
        }
      for (const Element &element : mesh.elements)
        if (is_marked_surface(element))
        {
          const std::string id = std::to_string(element.id);
          Nodes of_face;
          for (const unsigned int node : element.nodes)
            of_face.push_back(vertex_of_node[node]);
          const auto face = faces.find(sorted(of_face));
          if (face == faces.end())
            mesh.file.refuse("a surface with the physical id " + id + near(element.nodes) +
                                 ", is not one of the marked volumes",
                             "mark the volume behind it, " + volumes_of(body) +
                                 ", or not its surface");
          if (!face->second->at_boundary())
            mesh.file.refuse("a physical surface lies inside the body (physical id " + id + ")" +
                                 near(element.nodes),
                             "mark outer surfaces only" + or_without_partitions());
          const types::boundary_id before = face->second->boundary_id();
          if (before != ids::free && before != element.id)
            mesh.file.refuse("a surface has the physical ids " + std::to_string(before) + " and " +
                                 id + near(element.nodes),
                             "give each surface one physical id at most");
          face->second->set_boundary_id(element.id);
        }
    }

    /** @throws UserError for a mesh that leaves more than a quarter of the circle empty */
    void check_ring(const MeshFile &file, const Triangulation<3> &triangulation)
    {
      std::vector<double> angles;
      for (const Point<3> &vertex : triangulation.get_vertices())
        angles.push_back(cylindrical(vertex)[1]);
      std::sort(angles.begin(), angles.end());
      angles.push_back(angles.front() + 2. * numbers::PI);
      constexpr double degree = numbers::PI / 180.;
      for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        if (angles[i + 1] - angles[i] > 0.5 * numbers::PI)
          file.refuse("it is not a whole ring: it has no nodes between the angles " +
                          std::to_string(std::lround(angles[i] / degree)) + " and " +
                          std::to_string(std::lround(angles[i + 1] / degree)) + " degrees",
                      "mesh all of the ring or, of one sector, mark the cuts");
    }

    SectorForm form_of(const MeshFile &file, const Triangulation<3> &triangulation,
                       const Domain domain)
    {
      const std::vector<types::boundary_id> found = triangulation.get_boundary_ids();
      const auto marked                           = [&](const types::boundary_id id)
      { return std::count(found.begin(), found.end(), id) > 0; };
      const bool half  = marked(ids::mirror) && marked(ids::cut);
      const bool whole = marked(ids::cut_low) && marked(ids::cut_high);
      const bool mixed = half ? marked(ids::cut_low) || marked(ids::cut_high)
                              : marked(ids::mirror) || marked(ids::cut);
      if (domain == Domain::ring && !half && !whole && !mixed)
      {
        check_ring(file, triangulation);
        return SectorForm::ring;
      }
      if ((!half && !whole) || mixed)
        file.refuse(half || whole ? "it has the surfaces of a half and of a whole sector"
                                  : "the cuts are not marked",
                    "mark either 11 (mirror plane theta = 0) and 12 (cut), or 13 and 14 (the two "
                    "cuts), as physical surfaces; a whole ring has none and needs Modes/Domain = "
                    "ring");
      return half ? SectorForm::half : SectorForm::whole;
    }
  } // namespace

  SectorMesh read_sector(const std::string &file, const unsigned int n_sectors,
                         MPI_Comm communicator, const BodyOf of, const Domain domain)
  {
    GmshMesh gmsh = read_gmsh({file, of == BodyOf::stator ? "Stator/Mesh file" : "Rotor/Mesh file",
                               "hexahedra of first order (meshes/README.md)"});
    check_kinds(gmsh, of);
    take_ids(gmsh, of);
    SectorMesh mesh{empty_triangulation<3>(communicator), SectorForm::half, n_sectors};
    Triangulation<3> &triangulation = *mesh.triangulation;
    MeshOfFile body(gmsh, of);
    body.create(triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, CylindricalManifold<3>(2));
    check_cells(triangulation, gmsh.file);
    body.mark(triangulation);
    check_connections(triangulation, gmsh.file);
    mesh.form = form_of(gmsh.file, triangulation, domain);
    if (mesh.form == SectorForm::ring)
    {
      mesh.n_sectors = 1;
      mesh.has_cuts  = false;
      return mesh;
    }
    check_cuts(mesh, gmsh.file);
    if (of == BodyOf::stator)
      check_tooth(mesh, gmsh.file);
    else
      check_lip(mesh, gmsh.file);
    move_to_exact_places(mesh);
    return mesh;
  }
} // namespace ringmotor

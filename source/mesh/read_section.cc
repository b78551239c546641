// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_names.h>
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/gmsh_mesh.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/read_section.h>
#include <ringmotor/mesh/shell_line.h>
#include <ringmotor/mesh/split_elements.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    BodyNames names_of_edges(const BodyOf body)
    {
      BodyNames names = names_of_faces(body);
      if (body == BodyOf::rotor)
        names.emplace_back("shell", ids::shell_root);
      return names;
    }

    /** Makes a section from the elements of a file. */
    class SectionReader
    {
    public:
      SectionReader(const GmshMesh &mesh, const BodyOf body)
          : mesh(mesh), parts(names_of_parts(body)), edges(names_of_edges(body)), body(body),
            point_of_node(mesh.nodes.size(), numbers::invalid_unsigned_int)
      {
      }

      Section read()
      {
        check_kinds();
        for (const Element &element : mesh.elements)
          if (element.kind == GmshMesh::quadrilateral)
            add_cell(element);
        check_body(section, mesh.file);
        at_edges = section.cells_at_edges();
        for (const Element &element : mesh.elements)
          if (element.kind == GmshMesh::line)
            add_to_shell(element);
        for (const Element &element : mesh.elements)
          if (element.kind == GmshMesh::line)
            add_name(element);
        check_parts();
        add_shell();
        check_contact();
        if (body == BodyOf::stator)
          check_teeth(section, mesh.file);
        return std::move(section);
      }

    private:
      using Element = GmshMesh::Element;

      [[noreturn]] void refuse(const std::string &found, const std::string &what_to_do) const
      {
        mesh.file.refuse(found, what_to_do);
      }

      Point<2> middle(const std::vector<unsigned int> &nodes) const
      {
        Point<2> sum;
        for (const unsigned int node : nodes)
          sum += 1. / nodes.size() * Point<2>(mesh.nodes[node][0], mesh.nodes[node][1]);
        return sum;
      }

      unsigned int id_of(const Element &element, const long dimension, const BodyNames &names,
                         const std::string &what) const
      {
        const std::string name = mesh.name_of(dimension, element);
        for (const auto &[known, id] : names)
          if (known == name)
            return id;
        const std::string place = ", at " + in_words(middle(element.nodes));
        if (element.id != 0 && name.empty())
          refuse("a " + what + " has the physical id " + std::to_string(element.id) +
                     " but no name" + place,
                 "name it, Physical " + std::string(dimension == 2 ? "Surface" : "Curve") +
                     "(\"...\"), one of " + list_of(names) +
                     "; format 1 of Gmsh's files has no names");
        if (element.id == 0)
          refuse("a " + what + " has no name" + place,
                 "make it a part of Physical " + std::string(dimension == 2 ? "Surface" : "Curve") +
                     "(\"...\"), named " + list_of(names) + ", and do not set Mesh.SaveAll");
        refuse("a " + what + " has the name '" + name + "'" + place, "allowed: " + list_of(names));
      }

      void check_kinds() const
      {
        const std::string advice = "mesh the surfaces with quadrilaterals (Gmsh: Transfinite "
                                   "Surface \"*\"; Recombine Surface \"*\";) of first or second "
                                   "order";
        bool has_cells           = false;
        for (const Element &element : mesh.elements)
        {
          has_cells = has_cells || element.kind == GmshMesh::quadrilateral;
          if (element.kind == GmshMesh::triangle)
            refuse("it has triangles, one at " + in_words(middle(element.nodes)), advice);
          if (element.kind != GmshMesh::quadrilateral && element.kind != GmshMesh::line)
            refuse(element.nodes.empty()
                       ? "it has elements of Gmsh's kind " + std::to_string(element.kind)
                       : "it has volumes: a section lies in a plane",
                   element.nodes.empty() ? advice : "mesh in two dimensions: gmsh -2");
        }
        if (!has_cells)
          refuse("it has no quadrilaterals", advice);
      }

      Point<2> place(const unsigned int node) const
      {
        const Point<3> &x = mesh.nodes[node];
        const Point<2> in_plane(x[0], x[1]);
        if (std::abs(x[2]) > places::file_rounding * in_plane.norm())
          refuse("a point has the third coordinate " + in_metres(x[2]) + ", at " +
                     in_words(in_plane),
                 "draw the section in the plane of x = r and y = z, with a third coordinate of 0");
        return in_plane;
      }

      unsigned int point(const unsigned int node)
      {
        unsigned int &point = point_of_node[node];
        if (point == numbers::invalid_unsigned_int)
        {
          point = section.points.size();
          section.points.push_back(place(node));
        }
        return point;
      }

      void add_cell(const Element &element)
      {
        Section::Cell cell;
        cell.part = id_of(element, 2, parts, "surface");
        for (unsigned int i = 0; i < 4; ++i)
          cell.corners[i] = point(element.nodes[i]);
        const auto turn = [&](const unsigned int i)
        {
          const Point<2> &here = section.points[cell.corners[i]],
                         &next = section.points[cell.corners[(i + 1) % 4]],
                         &far  = section.points[cell.corners[(i + 2) % 4]];
          const Tensor<1, 2> a = next - here, b = far - next;
          return (a[0] * b[1] - a[1] * b[0]) / (a.norm() * b.norm());
        };
        if (turn(0) < 0. && turn(1) < 0. && turn(2) < 0. && turn(3) < 0.)
          std::reverse(cell.corners.begin(), cell.corners.end());
        constexpr double flat = 0.02;
        for (unsigned int i = 0; i < 4; ++i)
          if (!(turn(i) > flat))
            refuse("a cell is not convex or has a straight corner, at " +
                       in_words(middle(element.nodes)),
                   "divide the surface into blocks with four corners each");
        section.cells.push_back(cell);
      }

      /** Whether a line belongs to the curve `shell`, whatever other names it has. */
      bool is_of_shell(const Element &element) const
      {
        return shell.count(Section::edge(element.nodes[0], element.nodes[1])) > 0;
      }

      void add_to_shell(const Element &element)
      {
        if (element.id == 0 || id_of(element, 1, edges, "curve") != ids::shell_root)
          return;
        const Section::Edge edge =
            Section::edge(point_of_node[element.nodes[0]], point_of_node[element.nodes[1]]);
        if (at_edges.count(edge) > 0)
          refuse("the curve 'shell' is an edge of a surface, at " + in_words(middle(element.nodes)),
                 "draw it beside the surfaces, from a free end to an edge of them");
        shell[Section::edge(element.nodes[0], element.nodes[1])] = false;
      }

      void add_name(const Element &element)
      {
        if (element.id == 0)
          return;
        const unsigned int name = id_of(element, 1, edges, "curve");
        if (is_of_shell(element))
        {
          if (name != ids::lip && name != ids::shell_root)
            refuse("the curve 'shell' has the name '" + mesh.name_of(1, element) + "', too, at " +
                       in_words(middle(element.nodes)),
                   "allowed besides shell: contact");
          if (name == ids::lip)
            shell.at(Section::edge(element.nodes[0], element.nodes[1])) = true;
          return;
        }
        const Section::Edge edge =
            Section::edge(point_of_node[element.nodes[0]], point_of_node[element.nodes[1]]);
        const std::string what = "the curve '" + mesh.name_of(1, element) + "', at " +
                                 in_words(middle(element.nodes)) + ",";
        const auto cells = at_edges.find(edge);
        if (cells == at_edges.end())
          refuse(what + " is not an edge of the section", "name edges of the surfaces only");
        if (cells->second.size() > 1)
          refuse(what + " lies inside the section", "name outer edges only");
        const auto [entry, is_new] = section.names.emplace(edge, name);
        if (!is_new && entry->second != name)
          refuse(what + " has a second name", "give each edge one name");
      }

      void check_parts() const
      {
        if (body == BodyOf::stator && !section.has_part(ids::base))
          refuse("it has no base", "name the metal that the slots do not reach: Physical "
                                   "Surface(\"base\")");
        if (body == BodyOf::rotor && !section.has_part(ids::rotor))
          refuse("it has no rotor", "name the metal of the rotor: Physical Surface(\"rotor\")");
      }

      void add_shell()
      {
        if (shell.empty())
          return;
        std::vector<ShellPiece> pieces;
        std::vector<Point<2>> places(mesh.nodes.size());
        for (const auto &[nodes, in_contact] : shell)
        {
          pieces.push_back({nodes, in_contact});
          for (const unsigned int node : {nodes.first, nodes.second})
            places[node] = place(node);
        }
        section.shell = shell_line(pieces, places, section, mesh.file);
        if (section.shell.n_in_contact > 0 && !section.edges_named(ids::lip).empty())
          refuse("the curve 'contact' lies on the shell and on surfaces",
                 "let one of them touch the teeth");
      }

      /** The contact line must face the other body. */
      void check_contact() const
      {
        const unsigned int contact = edges.front().second;
        const double up            = body == BodyOf::stator ? 1. : -1.;
        for (const Section::Edge &edge : section.edges_named(contact))
        {
          const Section::Cell &cell = section.cells[at_edges.at(edge).front()];
          const Point<2> place = 0.5 * (section.points[edge.first] + section.points[edge.second]);
          const Tensor<1, 2> along = section.points[edge.second] - section.points[edge.first];
          if (up * (place - section.middle(cell))[1] <= 0. ||
              std::abs(along[1]) > std::abs(along[0]))
            refuse("the curve 'contact' does not face the " +
                       std::string(body == BodyOf::stator ? "rotor" : "stator") + ", at " +
                       in_words(place),
                   body == BodyOf::stator ? "name the tops of the teeth, which face +z"
                                          : "name the lower face of lip or lining, which faces -z");
          if (body == BodyOf::stator && cell.part != ids::tooth)
            refuse("the curve 'contact' lies on the base, at " + in_words(place),
                   "name the tops of the part 'tooth'");
        }
      }

      const GmshMesh &mesh;
      const BodyNames parts, edges;
      const BodyOf body;
      std::vector<unsigned int> point_of_node;
      Section section;
      std::map<Section::Edge, std::vector<unsigned int>> at_edges;
      std::map<Section::Edge, bool> shell; ///< whether its lines, by nodes, are in contact
    };
  } // namespace

  Section read_section(const std::string &file, const BodyOf body)
  {
    const GmshMesh mesh = with_split_elements(
        read_gmsh({file, body == BodyOf::stator ? "Stator/Section file" : "Rotor/Section file",
                   "quadrilaterals of first or second order (meshes/README.md)"}));
    return SectionReader(mesh, body).read();
  }
} // namespace ringmotor

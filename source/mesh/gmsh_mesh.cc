// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/gmsh_mesh.h>
#include <ringmotor/mesh/mesh_lines.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <unordered_map>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Ids = std::vector<long>;

    /** How many nodes an element of a kind has; 0: a kind that is not read. */
    std::size_t n_nodes_of(const long kind)
    {
      static const std::map<long, std::size_t> n_nodes{{GmshMesh::point, 1},
                                                       {GmshMesh::line, 2},
                                                       {GmshMesh::triangle, 3},
                                                       {GmshMesh::quadrilateral, 4},
                                                       {GmshMesh::tetrahedron, 4},
                                                       {GmshMesh::hexahedron, 8},
                                                       {GmshMesh::prism, 6},
                                                       {GmshMesh::pyramid, 5},
                                                       {GmshMesh::line_of_3, 3},
                                                       {GmshMesh::quadrilateral_of_9, 9},
                                                       {GmshMesh::quadrilateral_of_8, 8}};
      const auto found = n_nodes.find(kind);
      return found == n_nodes.end() ? 0 : found->second;
    }

    /** What stands in @p text between a word and the next @p end, or nothing. */
    std::string between(const std::string &text, const std::string &word, const char end)
    {
      const std::size_t at = text.find(word);
      if (at == std::string::npos)
        return "";
      const std::size_t begin = at + word.size();
      return text.substr(begin, text.find(end, begin) - begin);
    }

    class GmshReader
    {
    public:
      explicit GmshReader(const MeshFile &file) : mesh{file, {}, {}, false, {}}, lines(mesh.file)
      {
        mesh.file.n_digits = 0; // before the first one
      }

      GmshMesh read()
      {
        bool has_nodes = false, has_elements = false;
        while (lines.go_on())
        {
          const std::string title = lines.word(0);
          lines.expect(title.size() > 1 && title[0] == '$' && lines.n_words() == 1);
          if (title == "$MeshFormat")
            format();
          else if (title == "$PhysicalNames")
            physical_names();
          else if (title == "$Entities")
            entities(false);
          else if (title == "$PartitionedEntities")
            entities(true);
          else if (title == "$Nodes" || title == "$NOD" || title == "$ParametricNodes")
          {
            version       = title == "$NOD" ? 1. : version;
            is_parametric = title == "$ParametricNodes";
            lines.expect(version > 0. && !has_nodes);
            has_nodes = true;
            version > 4. ? blocks_of_nodes() : nodes();
          }
          else if (title == "$Elements" || title == "$ELM")
          {
            lines.expect(has_nodes && !has_elements);
            has_elements = true;
            version > 4. ? blocks_of_elements() : elements();
          }
          else
            lines.skip_to("$End" + title.substr(1));
          const bool is_old = title == "$NOD" || title == "$ELM";
          lines.expect(lines.word(0) == (is_old ? "$END" : "$End") + title.substr(1));
        }
        lines.expect(has_nodes && has_elements);
        note_on_partitions();
        return std::move(mesh);
      }

    private:
      void format()
      {
        lines.next();
        version              = lines.number<double>(0);
        const bool is_binary = lines.count(1) != 0;
        const bool is_known  = version == 4.1 || (version >= 2. && version <= 2.2);
        const std::string advice =
            "save it in Gmsh's ASCII format of version 2.2 or 4.1 (Mesh.MshFileVersion)";
        if (is_binary)
          mesh.file.refuse("it is binary", advice + " with Mesh.Binary = 0");
        if (!is_known)
        {
          std::ostringstream found;
          found << "it is in version " << version << " of Gmsh's format";
          mesh.file.refuse(found.str(), advice);
        }
        lines.expect(lines.count(2) == 8);
        lines.next();
      }

      using Entity = std::pair<long, long>; ///< dimension and tag, or physical id

      /** Partitions that Gmsh has given ids of their own are named after the ids before:
       * "..._part{1}_physical{15}...". */
      void physical_names()
      {
        lines.next();
        const long n_names = lines.count(0);
        for (long i = 0; i < n_names; ++i)
        {
          lines.next();
          std::string name;
          for (std::size_t word = 2; word < lines.n_words(); ++word)
            name += (name.empty() ? "" : " ") + lines.word(word);
          const std::string parts  = between(name, "_part{", '}'),
                            before = between(name, "}_physical{", '}');
          if (parts.empty() || before.empty())
          {
            mesh.names[{lines.count(0), lines.count(1)}] = between(name, "\"", '"');
            continue;
          }
          // What lies between partitions is inside the body.
          const bool is_between = parts.find(',') != std::string::npos;
          ids_before[{lines.count(0), lines.count(1)}] =
              is_between ? 0 : std::strtol(before.c_str(), nullptr, 10);
        }
        lines.next();
      }

      /** The id at a place of the line, or that of what was divided. */
      long id(const long dimension, const std::size_t place) const
      {
        const long id     = lines.id(place);
        const auto before = ids_before.find({dimension, id});
        return before == ids_before.end() ? id : before->second;
      }

      void entities(const bool are_parts)
      {
        if (are_parts)
        {
          lines.next();
          lines.next();
          const long n_ghosts = lines.count(0);
          for (long ghost = 0; ghost < n_ghosts; ++ghost)
            lines.next();
        }
        lines.next();
        lines.expect(lines.n_words() == 4);
        std::array<long, 4> n_entities;
        for (long dimension = 0; dimension < 4; ++dimension)
          n_entities[dimension] = lines.count(dimension);
        for (long dimension = 0; dimension < 4; ++dimension)
          for (long i = 0; i < n_entities[dimension]; ++i)
          {
            lines.next();
            entity(dimension, are_parts);
          }
        lines.next();
      }

      /** tag [dimension and tag of what was divided, partitions] box ids [boundary] */
      void entity(const long dimension, const bool is_part)
      {
        const Entity self{dimension, lines.count(0)};
        if (is_part)
        {
          const Entity parent{lines.count(1), lines.count(2)};
          const long n_partitions = lines.count(3);
          for (long i = 0; i < n_partitions && parent.first == dimension; ++i)
            partitions[self].insert(lines.count(4 + i));
          // What lies between partitions has a parent of higher dimension, and is inside the body.
          ids[self] = parent.first == dimension ? ids[parent] : Ids();
          return;
        }
        const std::size_t place = dimension == 0 ? 4 : 7;
        const long n_ids        = lines.count(place);
        for (long i = 0; i < n_ids; ++i)
          ids[self].push_back(id(dimension, place + 1 + i));
      }

      void add_node(const long tag, const Point<3> &x)
      {
        lines.expect(node_of_tag.emplace(tag, mesh.nodes.size()).second);
        mesh.nodes.push_back(x);
      }

      void nodes()
      {
        lines.next();
        const long n_nodes = lines.count(0);
        for (long node = 0; node < n_nodes; ++node)
        {
          lines.next();
          // An entity and parameters on curves (1) and surfaces (2) may follow.
          const long dimension = is_parametric ? lines.count(4) : 0;
          lines.expect(lines.n_words() ==
                       (is_parametric ? 6 + static_cast<std::size_t>(dimension % 3) : 4));
          add_node(lines.count(0), lines.point(1));
        }
        lines.next();
      }

      /** Blocks of tags followed by as many points. */
      void blocks_of_nodes()
      {
        lines.next();
        lines.expect(lines.n_words() == 4);
        const long n_blocks = lines.count(0), n_nodes = lines.count(1);
        for (long b = 0; b < n_blocks; ++b)
        {
          lines.next();
          lines.expect(lines.n_words() == 4);
          const std::size_t n_parameters = lines.count(2) == 0 ? 0 : lines.count(0);
          const long n_in_block          = lines.count(3);
          std::vector<long> tags;
          for (long node = 0; node < n_in_block; ++node)
          {
            lines.next();
            lines.expect(lines.n_words() == 1);
            tags.push_back(lines.count(0));
          }
          for (const long tag : tags)
          {
            lines.next();
            lines.expect(lines.n_words() == 3 + n_parameters);
            add_node(tag, lines.point(0));
          }
        }
        lines.expect(mesh.nodes.size() == static_cast<std::size_t>(n_nodes));
        lines.next();
      }

      /** The element whose nodes stand at the end of the line, from a place on. */
      void add_element(const long kind, const std::size_t place, const Ids &ids_of_element)
      {
        GmshMesh::Element element{kind, 0, {}};
        const std::size_t n_nodes = n_nodes_of(kind);
        lines.expect(n_nodes == 0 || lines.n_words() == place + n_nodes);
        for (std::size_t i = 0; i < n_nodes; ++i)
        {
          const auto node = node_of_tag.find(lines.count(place + i));
          lines.expect(node != node_of_tag.end());
          element.nodes.push_back(node->second);
        }
        if (kind == GmshMesh::point)
          return;
        if (ids_of_element.empty())
          mesh.elements.push_back(element);
        for (const long id : ids_of_element)
        {
          element.id = id;
          mesh.elements.push_back(element);
        }
      }

      /** Version 1: number, kind, physical and elementary id, number of nodes. Version 2: number,
       * kind, number of tags, tags: physical and elementary id, number of partitions, these (those
       * of ghost cells negative). */
      void elements()
      {
        lines.next();
        const long n_elements = lines.count(0);
        for (long e = 0; e < n_elements; ++e)
        {
          lines.next();
          lines.count(0);
          const long kind = lines.count(1);
          if (version < 2.)
          {
            lines.count(3);
            lines.expect(lines.n_words() == 5 + static_cast<std::size_t>(lines.count(4)));
            add_element(kind, 5, {lines.id(2)});
            continue;
          }
          const long n_tags = lines.count(2);
          if (n_tags > 3 && lines.count(5) > 0 && kind == GmshMesh::hexahedron)
            partitions_seen.insert(lines.number<long>(6));
          const bool is_line   = kind == GmshMesh::line || kind == GmshMesh::line_of_3;
          const long dimension = kind == GmshMesh::hexahedron ? 3 : is_line ? 1 : 2;
          add_element(kind, 3 + n_tags, {n_tags > 0 ? id(dimension, 3) : 0});
        }
        lines.next();
      }

      void blocks_of_elements()
      {
        lines.next();
        lines.expect(lines.n_words() == 4);
        const long n_blocks = lines.count(0), n_elements = lines.count(1);
        long n_found = 0;
        for (long b = 0; b < n_blocks; ++b)
        {
          lines.next();
          lines.expect(lines.n_words() == 4 && lines.count(0) <= 3);
          const Entity entity{lines.count(0), lines.count(1)};
          const long kind = lines.count(2), n_in_block = lines.count(3);
          for (long e = 0; e < n_in_block; ++e)
          {
            lines.next();
            lines.count(0);
            add_element(kind, 1, ids[entity]);
          }
          if (kind == GmshMesh::hexahedron && n_in_block > 0)
            partitions_seen.insert(partitions[entity].begin(), partitions[entity].end());
          n_found += n_in_block;
        }
        lines.expect(n_found == n_elements);
        lines.next();
      }

      void note_on_partitions()
      {
        mesh.has_partitions = !partitions_seen.empty();
        if (partitions_seen.size() == 1)
          mesh.file.note = "its cells are those of partition " +
                           std::to_string(*partitions_seen.begin()) +
                           " alone: if there are more, save all in one file "
                           "(Mesh.PartitionSplitMeshFiles = 0)";
      }

      GmshMesh mesh;
      MeshLines lines;
      double version     = 0.;
      bool is_parametric = false;
      std::unordered_map<long, unsigned int> node_of_tag;
      std::map<Entity, Ids> ids;
      std::map<Entity, std::set<long>> partitions; ///< of entities
      std::set<long> partitions_seen;              ///< of volume elements
      std::map<Entity, long> ids_before; ///< the partition, by dimension and id of the partition
    };
  } // namespace

  GmshMesh read_gmsh(const MeshFile &file)
  {
    return GmshReader(file).read();
  }
} // namespace ringmotor

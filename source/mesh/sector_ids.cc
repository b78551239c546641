// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_names.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sector_ids.h>

#include <algorithm>
#include <map>
#include <set>

namespace ringmotor
{
  using namespace dealii;

  bool is_volume(const GmshMesh::Element &element)
  {
    return element.kind == GmshMesh::hexahedron;
  }

  bool is_marked_surface(const GmshMesh::Element &element)
  {
    return element.kind == GmshMesh::quadrilateral && element.id != ids::free;
  }

  std::string near_nodes(const GmshMesh &mesh, const std::vector<unsigned int> &nodes)
  {
    Point<3> center;
    for (const unsigned int node : nodes)
      center += 1. / nodes.size() * mesh.nodes[node];
    return ", near " + in_words(cylindrical(center));
  }

  namespace
  {
    using Element = GmshMesh::Element;
    BodyNames names_of_surfaces(const BodyOf body)
    {
      BodyNames names{{"mirror", ids::mirror},
                      {"cut", ids::cut},
                      {"cut low", ids::cut_low},
                      {"cut high", ids::cut_high}};
      const BodyNames faces = names_of_faces(body);
      names.insert(names.end(), faces.begin(), faces.end());
      return names;
    }

    /** Takes those of the elements of one dimension. */
    class IdsOfDimension
    {
    public:
      IdsOfDimension(GmshMesh &mesh, const BodyOf body, const long dimension)
          : mesh(mesh), body(body), dimension(dimension), is_of_volumes(dimension == 3),
            names(is_of_volumes ? names_of_parts(body) : names_of_surfaces(body))
      {
        if (body == BodyOf::stator) // files of before there were names
          numbers = is_of_volumes ? std::set<long>{ids::base, ids::tooth, ids::piezoceramic}
                                  : std::set<long>{ids::mirror, ids::cut, ids::cut_low,
                                                   ids::cut_high, ids::tooth_top};
      }

      void take(Element &element) const
      {
        const std::string name = mesh.name_of(dimension, element);
        const auto known       = std::find_if(names.begin(), names.end(),
                                              [&](const auto &each) { return each.first == name; });
        if (known != names.end())
          element.id = known->second;
        else if (numbers.count(element.id) == 0 && (is_of_volumes || element.id != 0))
          refuse(element, name);
      }

    private:
      [[noreturn]] void refuse(const Element &element, const std::string &name) const
      {
        const std::string what    = is_of_volumes ? "a volume has " : "a surface has ",
                          place   = near_nodes(mesh, element.nodes),
                          or_none = is_of_volumes ? ""
                                    : mesh.has_partitions // Gmsh may mark what lies between them
                                        ? ", or none; or save the mesh without partitions"
                                        : ", or none";
        if (!name.empty())
          mesh.file.refuse(what + "the name '" + name + "'" + place,
                           "allowed: " + list_of(names) + or_none);
        if (body == BodyOf::rotor)
          mesh.file.refuse(what + "no name" + place, "allowed: " + list_of(names) + or_none +
                                                         "; format 1 of Gmsh's files has no names");
        mesh.file.refuse(what + "the physical id " + std::to_string(element.id) +
                             (element.id == 0 ? ", which is none" : "") + place,
                         is_of_volumes ? "allowed are " + volumes_of(body)
                                       : "allowed are 11 (mirror plane), 12 (cut), 13 and 14 "
                                         "(cuts), 15 (tooth top), the names " +
                                             list_of(names) + or_none);
      }

      const GmshMesh &mesh;
      const BodyOf body;
      const long dimension;
      const bool is_of_volumes;
      const BodyNames names;
      std::set<long> numbers;
    };
  } // namespace

  std::string volumes_of(const BodyOf body)
  {
    return body == BodyOf::stator ? "1 (base), 2 (tooth) and 3 (piezoceramic)"
                                  : "names: rotor, lining and adhesive";
  }

  void take_ids(GmshMesh &mesh, const BodyOf body)
  {
    if (std::none_of(mesh.elements.begin(), mesh.elements.end(),
                     [](const Element &element) { return is_volume(element) && element.id != 0; }))
      mesh.file.refuse("its volumes have no physical ids",
                       (body == BodyOf::stator ? "mark them as physical volumes " + volumes_of(body)
                                               : "give physical volumes " + volumes_of(body)) +
                           ", and surfaces as meshes/README.md says; do not set Mesh.SaveAll, with "
                           "which Gmsh's format 2.2 loses the ids");
    const IdsOfDimension of_volumes(mesh, body, 3), of_surfaces(mesh, body, 2);
    for (Element &element : mesh.elements)
      if (is_volume(element))
        of_volumes.take(element);
      else if (element.kind == GmshMesh::quadrilateral)
        of_surfaces.take(element);
  }
} // namespace ringmotor

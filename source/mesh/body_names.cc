// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_names.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/section.h>

namespace ringmotor
{
  BodyNames names_of_parts(const BodyOf body)
  {
    BodyNames names;
    for (const auto part : body == BodyOf::stator
                               ? std::vector{ids::base, ids::tooth, ids::piezoceramic}
                               : std::vector{ids::rotor, ids::lining, ids::adhesive})
      names.emplace_back(name_of_part(part), part);
    return names;
  }

  BodyNames names_of_faces(const BodyOf body)
  {
    BodyNames names;
    for (const auto face :
         body == BodyOf::stator
             ? std::vector{ids::tooth_top, ids::clamped, ids::bottom}
             : std::vector{ids::lip, ids::ring_top, ids::ring_bore, ids::radial_bars, ids::clamped})
      names.emplace_back(name_of_edge(face), face);
    return names;
  }

  std::string list_of(const BodyNames &names)
  {
    std::string list;
    for (const auto &[name, id] : names)
      list += (list.empty() ? "" : name == names.back().first ? " or " : ", ") + name;
    return list;
  }
} // namespace ringmotor

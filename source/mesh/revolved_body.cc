// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_section.h>
#include <ringmotor/mesh/revolved.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/required.h>

#include <algorithm>

namespace ringmotor
{
  RevolvedBody stator_body(const StatorGeometry &stator, const unsigned int n_teeth)
  {
    const double top = stator.base_thickness + stator.tooth_height;
    Section section;
    const auto add_points = [&](const double inner, const double outer, const double z)
    {
      section.points.emplace_back(inner, z);
      section.points.emplace_back(outer, z);
    };
    for (const double z : {0., stator.base_thickness, top})
    {
      const double share = z / top;
      add_points(
          stator.base_inner_radius + share * (stator.tip_inner_radius - stator.base_inner_radius),
          stator.base_outer_radius + share * (stator.tip_outer_radius - stator.base_outer_radius),
          z);
    }
    section.cells       = {{{{0, 1, 3, 2}}, ids::base}, {{{2, 3, 5, 4}}, ids::tooth}};
    section.names       = {{Section::edge(4, 5), ids::tooth_top}};
    const bool has_ring = stator.piezoceramic_thickness > 0.,
               has_skin = has_ring && stator.piezoceramic_element == ElementKind::shell;
    if (has_ring && !has_skin)
    {
      add_points(stator.base_inner_radius, stator.base_outer_radius,
                 -stator.piezoceramic_thickness);
      section.cells.push_back({{{6, 7, 1, 0}}, ids::piezoceramic});
      section.names[Section::edge(6, 7)] = ids::bottom;
    }
    else
      section.names[Section::edge(0, 1)] = has_skin ? ids::skin : ids::bottom;
    return {section, slots_of(section, n_teeth, stator.slot_width),
            has_skin ? stator.piezoceramic_thickness : 0.};
  }

  namespace
  {
    /** @throws UserError for a part without material */
    void check_materials(const Parameters &parameters, const Section &section,
                         const std::string &entry)
    {
      for (const auto &[part, name, material] :
           {std::make_tuple(ids::piezoceramic, "piezoceramic", "Piezoceramic"),
            {ids::lining, "lining", "Lining"},
            {ids::adhesive, "adhesive", "Adhesive"}})
        if (std::any_of(section.cells.begin(), section.cells.end(),
                        [id = part](const Section::Cell &cell) { return cell.part == id; }))
          for (const char *const constant : {"Young modulus", "Poisson ratio", "Density"})
            check_given(parameters, entry + " has the part '" + name + "'",
                        {std::string("Materials/") + material + "/" + constant});
    }

    /** @throws UserError if there is no tooth between them */
    void check_slots(const Parameters &parameters, const Slots &slots)
    {
      if (!slots.has_teeth())
        return;
      if (!slots.angle)
        check_given(parameters,
                    "Stator/Section file has the part 'tooth'; give the width of a slot between "
                    "parallel walls, or Stator/Slot angle",
                    {"Stator/Slot width"});
      if (slots.half_width() >= slots.inner_radius * slots.half_pitch())
        throw UserError(
            (slots.angle ? "Stator/Slot angle = " + std::to_string(*slots.angle)
                         : entry("Stator/Slot width", slots.width)) +
            " leaves no tooth where teeth begin, at the " + entry("radius", slots.inner_radius) +
            "; allowed with " + entry("Motor/Number of teeth", slots.n_sectors) + ": less than " +
            (slots.angle
                 ? std::to_string(2. * slots.half_pitch())
                 : entry("the pitch there, width", 2. * slots.inner_radius * slots.half_pitch())));
    }
  } // namespace

  RevolvedBody stator_body(const Parameters &parameters)
  {
    const StatorGeometry &stator = parameters.stator;
    if (stator.section_file.empty())
      return stator_body(stator, parameters.motor.n_teeth);
    const Section section = read_section(stator.section_file, SectionOf::stator);
    check_materials(parameters, section, "Stator/Section file");
    const Slots slots =
        slots_of(section, parameters.motor.n_teeth, stator.slot_width, stator.slot_angle);
    check_slots(parameters, slots);
    return {section, slots};
  }

  RevolvedBody rotor_body(const Parameters &parameters)
  {
    const Section section = read_section(parameters.rotor.section_file, SectionOf::rotor);
    check_materials(parameters, section, "Rotor/Section file");
    return {section, {parameters.motor.n_teeth}};
  }
} // namespace ringmotor

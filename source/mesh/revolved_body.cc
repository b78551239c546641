// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_parts.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_section.h>
#include <ringmotor/mesh/revolved.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/mesh/shell_line.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/required.h>
#include <ringmotor/parameters/short_text.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

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
    std::function<bool(types::material_id)> has_part_of(const Section &section)
    {
      return [&section](const types::material_id part) { return section.has_part(part); };
    }

    /** Ties the shell of a section to its body, if it has one. @throws UserError for a shell
     * without thickness or the other way round, one that is not thin, and as name_shell_root() */
    void add_shell(RevolvedBody &body, const Parameters &parameters)
    {
      const std::string entry                = "Rotor/Shell thickness";
      const std::optional<double> &thickness = parameters.rotor.shell_thickness;
      const std::vector<Point<2>> &line      = body.section.shell.points;
      if (line.empty() && thickness)
        throw UserError(ringmotor::entry(entry, *thickness) +
                        ", but Rotor/Section file has no curve 'shell'; name it, Physical "
                        "Curve(\"shell\"), or give none");
      if (line.empty())
        return;
      if (!thickness)
        throw UserError("Rotor/Section file has the curve 'shell', but " + entry +
                        " is none; give the thickness of that shell in m");
      double length = 0.;
      for (unsigned int i = 0; i + 1 < line.size(); ++i)
        length += line[i].distance(line[i + 1]);
      if (*thickness > most_shell_thickness * length)
        throw UserError(
            ringmotor::entry(entry, *thickness) +
            " is not thin compared to the length of the curve 'shell'; allowed: up to " +
            ringmotor::entry("30 % of it, here " + entry, most_shell_thickness * length) +
            ", or surfaces instead of the curve");
      body.shell_thickness = *thickness;
      name_shell_root(body.section, *thickness,
                      {parameters.rotor.section_file, "Rotor/Section file", ""});
      body.thinnest = thinnest_with_shell(body.section, *thickness);
    }

    /** The same with the shape of its contact line as a profile. */
    RevolvedBody with_level_face(RevolvedBody body, const types::boundary_id contact)
    {
      body.face    = face_profile(body.section, contact);
      body.section = levelled(std::move(body.section), contact, body.face);
      return body;
    }

    /** @throws UserError if there is no tooth between them */
    void check_slots(const Parameters &parameters, const Slots &slots)
    {
      if (!slots.has_teeth())
        return;
      if (!slots.angle)
      {
        check_given(parameters,
                    "Stator/Section file has the part 'tooth'; give the width of a slot between "
                    "parallel walls, or Stator/Slot angle",
                    {"Stator/Slot width"});
        check_slot_width(slots.width, slots.inner_radius, slots.n_sectors);
        return;
      }
      const double widest = most_slot * 2. * slots.half_pitch();
      if (*slots.angle > widest)
        throw UserError(
            "Stator/Slot angle = " + short_text(*slots.angle) + " leaves no tooth with " +
            entry("Motor/Number of teeth", slots.n_sectors) +
            "; allowed: up to 95 % of the pitch, here Stator/Slot angle = " + short_text(widest));
    }
  } // namespace

  RevolvedBody stator_body(const Parameters &parameters)
  {
    const StatorGeometry &stator = parameters.stator;
    if (stator.section_file.empty())
      return stator_body(stator, parameters.motor.n_teeth);
    const Section section   = read_section(stator.section_file, BodyOf::stator);
    const BodyOrigin origin = origin_of(parameters, BodyOf::stator);
    check_materials(parameters, origin, has_part_of(section));
    check_felt(parameters, origin, !section.edges_named(ids::bottom).empty());
    const Slots slots =
        slots_of(section, parameters.motor.n_teeth, stator.slot_width, stator.slot_angle);
    check_slots(parameters, slots);
    if (parameters.modes.body == Body::tooth && !slots.has_teeth())
      throw UserError("Modes/Body = tooth needs teeth, but " + stator.file_entry() +
                      " has no part 'tooth'; allowed: stator, or a section with it");
    return with_level_face({section, slots}, ids::tooth_top);
  }

  namespace
  {
    /** Blocks between lines of r and z. */
    class Blocks
    {
    public:
      unsigned int point(const double r, const double z)
      {
        const auto [entry, is_new] = points.emplace(std::make_pair(r, z), section.points.size());
        if (is_new)
          section.points.emplace_back(r, z);
        return entry->second;
      }

      void add(const double inner, const double outer, const double low, const double high,
               const types::material_id part)
      {
        section.cells.push_back(
            {{{point(inner, low), point(outer, low), point(outer, high), point(inner, high)}},
             part});
      }

      void name(const double r, const double z, const double other_r, const double other_z,
                const types::boundary_id id)
      {
        section.names[Section::edge(point(r, z), point(other_r, other_z))] = id;
      }

      Section section;

    private:
      std::map<std::pair<double, double>, unsigned int> points;
    };
  } // namespace

  RevolvedBody rotor_body(const RotorGeometry &rotor, const unsigned int n_teeth)
  {
    const bool is_shell = rotor.flange_element == ElementKind::shell;
    const double inner = rotor.ring_inner_radius, outer = rotor.ring_outer_radius,
                 low = rotor.flange_lower_face, high = low + rotor.flange_thickness,
                 bars = rotor.ring_upper_face - rotor.radial_bar_height,
                 // Stresses in the corners at the ring, which a shell cannot represent, have
                 // decayed this far away.
        root = inner - 0.5 * rotor.flange_thickness;
    Blocks blocks;
    const std::vector<double> heights{rotor.ring_lower_face, low, high, bars,
                                      rotor.ring_upper_face};
    for (unsigned int i = 0; i + 1 < heights.size(); ++i)
      if (heights[i] < heights[i + 1])
      {
        blocks.add(inner, outer, heights[i], heights[i + 1], ids::rotor);
        if (heights[i] != low)
          blocks.name(inner, heights[i], inner, heights[i + 1],
                      heights[i] == bars ? ids::radial_bars : ids::ring_bore);
      }
    blocks.name(inner, rotor.ring_upper_face, outer, rotor.ring_upper_face, ids::ring_top);
    RevolvedBody body;
    if (is_shell)
    {
      blocks.add(root, inner, low, high, ids::rotor);
      blocks.name(root, low, root, high, ids::shell_root);
      const double middle  = 0.5 * (low + high);
      blocks.section.shell = {
          {{rotor.lip_inner_radius, middle}, {rotor.lip_outer_radius, middle}, {root, middle}}, 1};
      body.shell_thickness = rotor.flange_thickness;
    }
    else
    {
      blocks.add(rotor.lip_outer_radius, inner, low, high, ids::rotor);
      blocks.add(rotor.lip_inner_radius, rotor.lip_outer_radius, low, high, ids::rotor);
      blocks.name(rotor.lip_inner_radius, low, rotor.lip_outer_radius, low, ids::lip);
    }
    body.section  = blocks.section;
    body.slots    = {n_teeth};
    body.thinnest = rotor.flange_thickness;
    if (rotor.radial_bar_stiffness > 0.)
      body.bar_stiffness = rotor.radial_bar_stiffness / rotor.radial_bar_height;
    return body;
  }

  RevolvedBody rotor_body(const Parameters &parameters)
  {
    if (parameters.rotor.section_file.empty())
      return rotor_body(parameters.rotor, parameters.motor.n_teeth);
    const Section section   = read_section(parameters.rotor.section_file, BodyOf::rotor);
    const BodyOrigin origin = origin_of(parameters, BodyOf::rotor);
    check_materials(parameters, origin, has_part_of(section));
    double height = 0.;
    for (const Section::Edge &edge : section.edges_named(ids::radial_bars))
      height += section.length(edge);
    RevolvedBody body{section, {parameters.motor.n_teeth}};
    body.bar_stiffness = bar_stiffness(parameters, origin, height);
    add_shell(body, parameters);
    return with_level_face(std::move(body), ids::lip);
  }
} // namespace ringmotor

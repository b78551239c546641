// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/sections_file.h>
#include <ringmotor/parameters/required.h>

#include <nlohmann/json.hpp>

#include <ostream>

namespace ringmotor
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /** @param rise m, by which the body is moved upwards */
    Json to_json(const RevolvedBody &body, const double rise, const Parameters &parameters)
    {
      const auto place       = [&](const dealii::Point<2> &x) { return Json{x[0], x[1] + rise}; };
      const Section &section = body.section;
      Json cells = Json::array(), edges = Json::array();
      for (const Section::Cell &cell : section.cells)
      {
        Json corners = Json::array();
        for (const unsigned int corner : cell.corners)
          corners.push_back(place(section.points[corner]));
        cells.push_back({{"part", name_of_part(cell.part)}, {"corners", corners}});
      }
      for (const auto &[edge, id] : section.names)
        if (const std::string name = name_of_edge(id);
            !name.empty() && (name != "felt" || parameters.support.has_felt()))
          edges.push_back(
              {{"name", name},
               {"ends", {place(section.points[edge.first]), place(section.points[edge.second])}}});
      Json json{{"cells", cells}, {"edges", edges}};
      if (!section.shell.points.empty())
      {
        Json points = Json::array();
        for (const dealii::Point<2> &point : section.shell.points)
          points.push_back(place(point));
        json["shell"] = {{"points", points},
                         {"segments_in_contact", section.shell.n_in_contact},
                         {"thickness", body.shell_thickness}};
      }
      if (body.skin_thickness > 0.)
        json["skin_thickness"] = body.skin_thickness;
      if (body.slots.has_teeth())
        json["slots"] = {{"number", body.slots.n_sectors},
                         {"width", body.slots.angle ? Json() : Json(body.slots.width)},
                         {"angle", body.slots.angle ? Json(*body.slots.angle) : Json()}};
      return json;
    }

    /** Whether there is a section of it. */
    bool has_rotor(const Parameters &parameters)
    {
      return parameters.rotor.mesh_file.empty() &&
             (!parameters.rotor.section_file.empty() ||
              missing_entries(parameters, {"Rotor/"}).empty());
    }
  } // namespace

  void print_sections(std::ostream &out, const Parameters &parameters)
  {
    Json json = Json::object();
    ContactLine tops;
    if (parameters.stator.mesh_file.empty() && parameters.modes.body != Body::rotor)
    {
      const RevolvedBody stator = stator_body(parameters);
      tops                      = contact_line(stator);
      json["stator"]            = to_json(stator, 0., parameters);
    }
    if (has_rotor(parameters))
    {
      const RevolvedBody rotor = rotor_body(parameters);
      json["rotor"] = to_json(rotor, tops.highest - contact_line(rotor).lowest, parameters);
    }
    out << json.dump(1) << std::endl;
  }

  void write_sections(const std::string &path, const Parameters &parameters)
  {
    write_file(path, [&](std::ostream &out) { print_sections(out, parameters); });
  }
} // namespace ringmotor

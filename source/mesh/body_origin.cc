// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/mesh/mesh_file.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>

namespace ringmotor
{
  std::string BodyOrigin::text() const
  {
    return entry + " = " + in_quotes(file);
  }

  std::string BodyOrigin::naming_of_face(const std::string &name) const
  {
    return std::string("Physical ") + (is_sector ? "Surface" : "Curve") + "(\"" + name + "\")";
  }

  std::string BodyOrigin::naming_of_part(const std::string &name) const
  {
    return std::string("Physical ") + (is_sector ? "Volume" : "Surface") + "(\"" + name + "\")";
  }

  void BodyOrigin::refuse(const std::string &found, const std::string &what_to_do) const
  {
    MeshFile{file, entry, ""}.refuse(found, what_to_do);
  }

  BodyOrigin origin_of(const Parameters &parameters, const BodyOf body)
  {
    const bool is_stator   = body == BodyOf::stator;
    const std::string name = is_stator ? "Stator" : "Rotor";
    const std::string &sector =
                          is_stator ? parameters.stator.mesh_file : parameters.rotor.mesh_file,
                      &section = is_stator ? parameters.stator.section_file
                                           : parameters.rotor.section_file;
    if (!sector.empty())
      return {name + "/Mesh file", sector, true};
    return {name + "/Section file", section, false};
  }

  BodyOrigin origin_of_modes(const Parameters &parameters)
  {
    return origin_of(parameters,
                     parameters.modes.body == Body::rotor ? BodyOf::rotor : BodyOf::stator);
  }
} // namespace ringmotor

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>

#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** Names of physical groups in the file of a body, with their ids of mesh/ids.h. */
  using BodyNames = std::vector<std::pair<std::string, unsigned int>>;

  /** Those of its parts. */
  BodyNames names_of_parts(const BodyOf body);
  /** Those of its faces, in a section of their edges; the contact first. */
  BodyNames names_of_faces(const BodyOf body);

  /** "base, tooth or piezoceramic" */
  std::string list_of(const BodyNames &names);
} // namespace ringmotor

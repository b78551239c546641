// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

namespace ringmotor
{
  /** 36 characters that identify these bytes (a name-based UUID: SHA-1, RFC 4122). */
  std::string fingerprint(const std::string_view bytes);

  /** The fingerprint of a file's content; that of an empty file if it cannot be read. */
  std::string fingerprint_of_file(const std::string &path);
} // namespace ringmotor

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/fingerprint.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <fstream>
#include <iterator>

namespace ringmotor
{
  std::string fingerprint(const std::string_view bytes)
  {
    const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
    return boost::uuids::to_string(generator(bytes.data(), bytes.size()));
  }

  std::string fingerprint_of_file(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    return fingerprint(std::string{std::istreambuf_iterator<char>(file), {}});
  }
} // namespace ringmotor

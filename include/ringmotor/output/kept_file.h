// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <optional>
#include <sstream>
#include <string>

namespace ringmotor
{
  /** What was read from a file of write_kept_file(). */
  struct KeptContent
  {
    std::optional<std::string> bytes;
    std::string problem; ///< why there are none, "is damaged"; empty if there is no file
  };

  /** Identifies the executable that is running, for keys of what only it may reuse. */
  std::string this_build();

  /**
   * Keeps the result of a computation for a later run, all or nothing. @p key is a text of all that
   * the result depends on; reading the file requires the same key.
   * @throws UserError if writing fails, see write_file()
   */
  void write_kept_file(const std::string &path, const std::string &key, const std::string &bytes);

  /**
   * Reads what write_kept_file() has kept under this path and this key. A file that is damaged,
   * even in a single bit, or has another key gives nothing.
   */
  KeptContent read_kept_file(const std::string &path, const std::string &key);

  /** Any object that boost can serialize, bit by bit. */
  template <typename T>
  std::string to_bytes(const T &object)
  {
    std::ostringstream stream;
    boost::archive::binary_oarchive(stream) << object;
    return stream.str();
  }

  /** Back from to_bytes() of the same program. */
  template <typename T>
  T from_bytes(const std::string &bytes)
  {
    T object;
    boost::iostreams::stream<boost::iostreams::array_source> stream(bytes.data(), bytes.size());
    boost::archive::binary_iarchive(stream) >> object;
    return object;
  }
} // namespace ringmotor

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
  /** What a file of write_kept_file() gave. */
  struct KeptContent
  {
    std::optional<std::string> bytes;
    std::string problem; ///< why there are none, "is damaged"; empty if there is no file
  };

  /**
   * Keeps the result of a computation for a later run, all or nothing. @p key is a text of all that
   * the result depends on: whoever looks for it has to know the same one.
   * @throws UserError if the disk refuses, see write_file()
   */
  void write_kept_file(const std::string &path, const std::string &key, const std::string &bytes);

  /**
   * Reads what write_kept_file() has kept under this path and this key. Neither a file that was
   * damaged, were it in a single bit, nor one with another key gives anything.
   */
  KeptContent read_kept_file(const std::string &path, const std::string &key);

  /** Any object that boost can serialize, to the last bit. */
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/mesh_file.h>

#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace ringmotor
{
  /** A mesh file in ASCII, read line by line and each line word by word. What is not there, or not
   * a number where one must be, makes the file a damaged one. */
  class MeshLines
  {
  public:
    /** @p file must outlive this object; its digits are counted. @throws UserError if it cannot be
     * opened */
    explicit MeshLines(MeshFile &file);

    /** Goes to the next line that is not empty, if there is one. */
    bool go_on();
    /** Goes to the next line that is not empty. */
    void next() { expect(go_on()); }
    /** Reads on to this line. */
    void skip_to(const std::string &title);

    std::size_t n_words() const { return words.size(); }
    std::string word(const std::size_t place) const;

    /** A number of this line. */
    template <typename Number>
    Number number(const std::size_t place) const
    {
      expect(words.size() > place);
      const char *const end = words[place].data() + words[place].size();
      Number value{};
      const auto read = std::from_chars(words[place].data(), end, value);
      expect(read.ec == std::errc() && read.ptr == end);
      return value;
    }
    /** One that is not negative. */
    long count(const std::size_t place) const;
    /** A physical id; it is negative where Gmsh turns elements round. */
    long id(const std::size_t place) const;
    /** Three finite coordinates from a place on. */
    dealii::Point<3> point(const std::size_t place);

    /** @throws UserError for a damaged file, with the line, if a @p condition does not hold */
    void expect(const bool condition) const;

  private:
    void split();

    MeshFile &file;
    std::ifstream input;
    std::string line;
    std::vector<std::string_view> words; ///< of the line
    std::size_t number_of_line = 0;
  };
} // namespace ringmotor

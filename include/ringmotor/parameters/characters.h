// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /** How a character can deceive the reader of a text, the mildest way first. */
  enum class Deception
  {
    foreign,    ///< outside ASCII, and none of the following
    look_alike, ///< taken for an ASCII character: dashes, curly quotes, full-width digits
    blank,      ///< taken for the blank of the space bar: no-break and other spaces
    invisible,  ///< not seen at all
    control     ///< a command to the terminal or a line end; a tab is none
  };

  /**
   * The first character of a @p text in UTF-8 that deceives at least as much as @p mildest, as the
   * end of a sentence about the text: `has U+00A0, a no-break space; delete it`. Empty if there is
   * none.
   */
  std::string deceptive_character(const std::string &text, Deception mildest);

  /** Why the bytes of a @p text are not UTF-8, as the end of a sentence about the text, with what
   * to do; empty if they are. */
  std::string encoding_problem(const std::string &text);

  /** The beginning of a @p text for a message: up to @p longest characters, and a question mark for
   * each that deceives as one not seen or a control character, or that is not UTF-8. */
  std::string visible(const std::string &text, std::size_t longest);
} // namespace ringmotor

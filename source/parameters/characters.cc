// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/characters.h>

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

namespace ringmotor
{
  namespace
  {
    using boost::locale::utf::code_point;
    using Utf8 = boost::locale::utf::utf_traits<char>;

    /** Neighbours in Unicode that deceive in the same way. */
    struct Deceptive
    {
      code_point first, last;
      Deception kind;
      const char *name;
      const char *advice;
    };

    const std::vector<Deceptive> &all_deceptive()
    {
      constexpr auto alike = Deception::look_alike, blank = Deception::blank,
                     invisible = Deception::invisible, control = Deception::control;
      const char *const remove = "delete it", *const space = "delete it or type a plain blank",
                        *const quotes = "leave out quotes", *const minus = "type the plain -",
                        *const plain          = "type the plain ASCII character",
                        *const power          = "write powers of ten as in 1.41e11";
      static const std::vector<Deceptive> all = {
          {0x0000, 0x0008, control, "a control character", remove},
          {0x000A, 0x001F, control, "a control character", remove},
          {0x007F, 0x009F, control, "a control character", remove},
          {0x2028, 0x2029, control, "a line separator", remove},
          {0x00AD, 0x00AD, invisible, "a soft hyphen", remove},
          {0x061C, 0x061C, invisible, "an invisible mark", remove},
          {0x180E, 0x180E, invisible, "an invisible mark", remove},
          {0x200B, 0x200B, invisible, "a zero-width space", remove},
          {0x200C, 0x200F, invisible, "a zero-width character", remove},
          {0x202A, 0x202E, invisible, "an invisible mark of direction", remove},
          {0x2060, 0x206F, invisible, "a zero-width character", remove},
          {0xFEFF, 0xFEFF, invisible, "a byte-order mark inside the text", remove},
          {0x00A0, 0x00A0, blank, "a no-break space", space},
          {0x1680, 0x1680, blank, "a space of another kind", space},
          {0x2000, 0x200A, blank, "a space of another width", space},
          {0x202F, 0x202F, blank, "a narrow no-break space", space},
          {0x205F, 0x205F, blank, "a space of another width", space},
          {0x3000, 0x3000, blank, "a full-width space", space},
          {0x2010, 0x2015, alike, "a hyphen or dash", minus},
          {0x2212, 0x2212, alike, "a minus sign", minus},
          {0xFE58, 0xFE63, alike, "a small dash", minus},
          {0x00AB, 0x00AB, alike, "a quotation mark", quotes},
          {0x00BB, 0x00BB, alike, "a quotation mark", quotes},
          {0x2018, 0x201F, alike, "a curly quotation mark", quotes},
          {0x2032, 0x203A, alike, "a prime or quotation mark", quotes},
          {0x00B7, 0x00B7, alike, "a dot in the middle of the line", power},
          {0x00D7, 0x00D7, alike, "a multiplication sign", power},
          {0x22C5, 0x22C5, alike, "a multiplication dot", power},
          {0x2070, 0x209C, alike, "a raised or lowered character", power},
          {0x2044, 0x2044, alike, "a fraction slash", plain},
          {0x2215, 0x2215, alike, "a division slash", plain},
          {0x0400, 0x052F, alike, "a Cyrillic letter", plain},
          {0x0660, 0x066C, alike, "an Arabic-Indic digit or sign", plain},
          {0x3001, 0x3002, alike, "a full-width comma or stop", plain},
          {0xFF01, 0xFF5E, alike, "a full-width character", plain},
          {0x1D7CE, 0x1D7FF, alike, "a digit of another typeface", plain},
          {0xFFFD, 0xFFFD, alike, "the sign for a character that a conversion has lost", plain}};
      return all;
    }

    const Deceptive *find_deceptive(const code_point point)
    {
      const auto found = std::find_if(all_deceptive().begin(), all_deceptive().end(),
                                      [=](const Deceptive &one)
                                      { return point >= one.first && point <= one.last; });
      return found == all_deceptive().end() ? nullptr : &*found;
    }

    /** `U+00A0` */
    std::string number_of(const code_point point)
    {
      std::ostringstream text;
      text << "U+" << std::hex << std::uppercase << std::setfill('0') << std::setw(4) << point;
      return text.str();
    }

    /** A character, or a byte that begins none, and the bytes that it takes. */
    struct Piece
    {
      code_point point; ///< Utf8::illegal or Utf8::incomplete if it is no character
      std::size_t begin, end;

      bool is_character() const { return boost::locale::utf::is_valid_codepoint(point); }
    };

    Piece piece_at(const std::string &text, const std::size_t begin)
    {
      auto rest              = text.begin() + begin;
      const code_point point = Utf8::decode(rest, text.end());
      const Piece piece{point, begin, static_cast<std::size_t>(rest - text.begin())};
      return piece.is_character() ? piece : Piece{point, begin, begin + 1};
    }

    std::string hex_of(const char byte)
    {
      std::ostringstream text;
      text << "0x" << std::hex << std::uppercase << std::setfill('0') << std::setw(2)
           << static_cast<unsigned int>(static_cast<unsigned char>(byte));
      return text.str();
    }

    /** ` in line 6`; nothing if there is one line only. */
    std::string line_of(const std::string &text, const std::size_t place)
    {
      if (text.find('\n') == std::string::npos)
        return "";
      return " in line " + std::to_string(1 + std::count(text.begin(), text.begin() + place, '\n'));
    }

    /** The name of an encoding with several bytes for each character that @p text has; empty if it
     * has none. Parameters begin with an ASCII character, of which zeros tell them. */
    std::string wide_encoding(const std::string &text)
    {
      const auto begins_with = [&text](const std::string &bytes)
      { return text.compare(0, bytes.size(), bytes) == 0; };
      const auto is_zero = [&text](const std::size_t place)
      { return text.size() > place && text[place] == '\0'; };
      if (begins_with({"\xFF\xFE\0\0", 4}) || begins_with({"\0\0\xFE\xFF", 4}))
        return "UTF-32";
      if (begins_with("\xFF\xFE") || begins_with("\xFE\xFF"))
        return "UTF-16";
      if (is_zero(1) && is_zero(2) && is_zero(3))
        return "UTF-32LE";
      if (is_zero(0) && is_zero(1) && is_zero(2))
        return "UTF-32BE";
      return is_zero(1) && !is_zero(0) ? "UTF-16LE" : is_zero(0) && !is_zero(1) ? "UTF-16BE" : "";
    }
  } // namespace

  std::string deceptive_character(const std::string &text, const Deception mildest)
  {
    for (std::size_t place = 0; place < text.size();)
    {
      const Piece piece            = piece_at(text, place);
      const Deceptive *const found = find_deceptive(piece.point);
      if (found && found->kind >= mildest)
        return "has " + number_of(piece.point) + ", " + found->name + "; " + found->advice;
      if (!found && piece.point >= 0x80 && mildest == Deception::foreign)
        return "has " + number_of(piece.point) + ", which is not an ASCII character";
      place = piece.end;
    }
    return "";
  }

  std::string encoding_problem(const std::string &text)
  {
    const std::string wide = wide_encoding(text);
    if (!wide.empty())
      return "is in " + wide +
             ", which some editors call Unicode; save it as UTF-8, or convert it: iconv -f " +
             wide + " -t UTF-8 OLD.prm > NEW.prm";
    for (std::size_t begin = 0; begin < text.size();)
    {
      const Piece piece = piece_at(text, begin);
      if (!piece.is_character())
        return "has the byte " + hex_of(text[begin]) + line_of(text, begin) +
               ", which is not UTF-8; save it as UTF-8, or convert it from its encoding, such as: "
               "iconv -f ISO-8859-1 -t UTF-8 OLD.prm > NEW.prm";
      begin = piece.end;
    }
    return "";
  }

  std::string visible(const std::string &text, const std::size_t longest)
  {
    std::string shown;
    std::size_t begin = 0;
    for (std::size_t n_shown = 0; begin < text.size() && n_shown < longest; ++n_shown)
    {
      const Piece piece            = piece_at(text, begin);
      const Deceptive *const found = find_deceptive(piece.point);
      const bool is_hidden         = !piece.is_character() || piece.point == '\t' ||
                             (found && found->kind >= Deception::invisible);
      shown += is_hidden ? "?" : text.substr(begin, piece.end - begin);
      begin = piece.end;
    }
    return shown + (begin < text.size() ? "..." : "");
  }
} // namespace ringmotor

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/prm_file.h>

#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** `Section/Sub/Entry` of all entries. The defaults, unlike the values of a user, hold nothing
     * that a parameter file cannot express. */
    std::vector<std::string> names_of_entries()
    {
      Parameters defaults;
      ParameterHandler prm;
      defaults.declare(prm);
      std::ostringstream text;
      prm.print_parameters(text,
                           ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
      std::vector<std::string> names;
      for (const PrmFile::Assignment &assignment : parse_prm(text.str(), "defaults").assignments)
        names.push_back(assignment.path);
      return names;
    }
  } // namespace

  Entries entries_of(const Parameters &parameters)
  {
    static const std::vector<std::string> names = names_of_entries();
    Parameters copy                             = parameters;
    ParameterHandler prm;
    copy.declare(prm);
    const std::vector<std::string> &left_out = parameters.not_given;
    Entries entries;
    for (const std::string &name : names)
    {
      if (std::find(left_out.begin(), left_out.end(), name) != left_out.end())
        continue;
      std::vector<std::string> path;
      boost::algorithm::split(path, name, [](const char letter) { return letter == '/'; });
      const std::string entry = path.back();
      path.pop_back();
      entries.emplace_back(name, prm.get(path, entry));
    }
    return entries;
  }

  void print_template(std::ostream &out)
  {
    Parameters defaults;
    ParameterHandler prm;
    defaults.declare(prm);
    const DeclaredEntries declared(prm);
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    std::set<unsigned int> required;
    for (const PrmFile::Assignment &assignment : parse_prm(text.str(), "defaults").assignments)
      if (declared.find(assignment.path)->is_required)
        required.insert(assignment.line);
    unsigned int number = 0;
    for (std::string line; std::getline(text, line);)
      out << (required.count(++number) == 0 ? line
                                            : line.substr(0, line.find('=') + 1) + " # required")
          << '\n';
  }

  void print_declarations(std::ostream &out)
  {
    using Json = nlohmann::ordered_json;
    Parameters defaults;
    ParameterHandler prm;
    defaults.declare(prm);
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
    Json declared                            = Json::parse(text);
    const std::function<void(Json &)> remove = [&](Json &tree)
    {
      for (Json &node : tree)
        if (!node.contains("pattern_description"))
          remove(node);
        else if (DeclaredEntries::says_required(node["documentation"]))
          node["default_value"] = node["value"] = "";
    };
    remove(declared);
    out << declared.dump(4) << '\n';
  }
} // namespace ringmotor

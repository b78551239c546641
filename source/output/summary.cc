// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ringmotor
{
  namespace
  {
    // Keeps the keys in the order in which they are written here.
    using Json = nlohmann::ordered_json;

    /** JSON has neither nan nor inf (the library would silently write null). */
    double finite(const double number, const std::string &owner)
    {
      if (!std::isfinite(number))
        throw ComputationError("The summary of the run cannot be written: " + owner + " is " +
                               std::to_string(number) + ", not a finite number");
      return number;
    }

    Json to_json(const Summary::Result &result)
    {
      const auto &[quantity, seconds, labels] = result;
      const std::string owner                 = "the quantity '" + quantity.name + "'";

      Json json = {{"name", quantity.name}};
      for (const auto &[key, label] : labels)
        std::visit([&json, &key = key](const auto &value) { json[key] = value; }, label);
      json["value"] = finite(quantity.value(), owner);
      json["unit"]  = quantity.unit.si;
      if (!quantity.has_error)
        return json;
      json["error"]        = quantity.estimate.error();
      json["error_causes"] = Json::object();
      for (const auto &[cause, error] : quantity.estimate.errors)
        json["error_causes"][cause] = finite(error, "the error '" + cause + "' of " + owner);
      json["seconds"] = seconds;
      return json;
    }

    Json to_json(const EffectRow &effect)
    {
      const Json indicator =
          effect.indicator
              ? Json(finite(*effect.indicator, "the indicator of '" + effect.name + "'"))
              : Json();
      return {{"name", effect.name},       {"indicator", indicator},
              {"choice", effect.choice},   {"automatic", effect.is_automatic},
              {"seconds", effect.seconds}, {"dofs", effect.dofs},
              {"bytes", effect.bytes}};
    }

    Json to_json(const Parameters::Variant::Difference &difference)
    {
      return {{"entry", difference.entry},
              {"value", difference.value},
              {"value_of_base", difference.value_of_base}};
    }

    Json to_json(const Summary::Check &check)
    {
      return {{"name", check.name},
              {"value", finite(check.value, "the check '" + check.name + "'")},
              {"limit", finite(check.limit, "the limit of the check '" + check.name + "'")},
              {"holds", check.holds()}};
    }

    template <typename Item>
    Json list(const std::vector<Item> &items)
    {
      Json json = Json::array();
      for (const Item &item : items)
        json.push_back(to_json(item));
      return json;
    }
  } // namespace

  void add_quantities(Summary &summary, const std::vector<Quantity> &quantities,
                      const double seconds, const Summary::Labels &labels)
  {
    for (const Quantity &quantity : quantities)
      summary.results.push_back({quantity, seconds, labels});
  }

  std::string describe(const EffectRow &row)
  {
    std::string line =
        "Effects/" + row.name + " = " + (row.is_automatic ? "auto: " + row.choice : row.choice);
    if (row.indicator)
      line += "; it " + std::string(row.choice == "on" ? "changes" : "would change") +
              " the results by about " + text(100. * *row.indicator, 2) + " %";
    if (row.seconds > 0.1)
      line += ", found in " + text(row.seconds, 1) + " s";
    return line;
  }

  bool is_certified(const Summary &summary)
  {
    return !summary.certificate.empty() &&
           std::all_of(summary.certificate.begin(), summary.certificate.end(),
                       [](const Summary::Check &check) { return check.holds(); });
  }

  void write_summary(const std::string &path, const Summary &summary)
  {
    Json seconds = Json::object();
    for (const auto &[phase, duration] : summary.seconds)
      seconds[phase] = duration;

    Json entries = Json::object();
    for (const auto &[name, text] : summary.entries)
      entries[name] = text;

    Json json = {
        {"program", summary.program},
        {"version", summary.version},
        {"git", summary.git},
        {"blas_kernel", summary.blas_kernel},
        {"prm", summary.prm},
        {"entries", entries},
        {"identity", {{"wave", summary.identity.wave}, {"motor", summary.identity.motor}}},
        {"seconds", seconds},
        {"peak_memory_MB", summary.peak_memory_MB},
        {"ranks",
         {{"shared_seconds", summary.ranks.by_rank}, {"longest_shares", summary.ranks.longest}}},
        {"dofs", summary.dofs},
        {"quantities", Json::array()},
        {"effects", list(summary.effects)},
        {"certificate", {{"holds", is_certified(summary)}, {"checks", list(summary.certificate)}}}};
    if (!summary.variant.base.empty())
      json["variant"] = {{"base", summary.variant.base},
                         {"differences", list(summary.variant.differences)}};
    for (const Summary::Result &result : summary.results)
      json[result.quantity.has_error ? "quantities" : "quantities_without_error"].push_back(
          to_json(result));
    // The prm is the user's text and may hold bytes that are not UTF-8: not worth losing a run.
    write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  }
} // namespace ringmotor

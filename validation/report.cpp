// SPDX-License-Identifier: Apache-2.0
// Outcomes for people and programs: a line, JSON, a page.
#include <cmath>
#include <cstdio>

#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

std::string Number(double value, const char* format = "%.2e") {
    char text[40];
    std::snprintf(text, sizeof text, value == 0 ? "%g" : format, value);
    return text;
}

std::string Quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", c);
            quoted += code;
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string QuotedList(const std::vector<std::string>& texts) {
    std::string list = "[";
    for (const std::string& text : texts) list += (list.size() > 1 ? ", " : "") + Quoted(text);
    return list + "]";
}

std::string Escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '<') {
            escaped += "&lt;";
        } else if (c == '&') {
            escaped += "&amp;";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string HtmlList(const char* title, const std::vector<std::string>& texts) {
    if (texts.empty()) return {};
    std::string html = std::string("<p>") + title + "</p><ul>";
    for (const std::string& text : texts) html += "<li>" + Escaped(text) + "</li>";
    return html + "</ul>\n";
}

}  // namespace

std::string LineOf(const Outcome& outcome) {
    const Findings& found = outcome.findings;
    char head[80];
    std::snprintf(head, sizeof head, "%-7s  %-20s", std::string(NameOf(outcome.status)).c_str(),
                  std::string(outcome.validator->name).c_str());
    std::string line = head;
    if (outcome.status == Status::Skipped) return line + "  " + outcome.reason;
    if (found.n_compared > 0) {
        line += "  largest error " + Number(found.largest_error) + " (may be " + Number(outcome.validator->tolerance) +
                ") in " + std::to_string(found.n_compared) + " comparisons, " + Number(outcome.seconds, "%.1f") + " s";
    }
    if (!found.skipped.empty()) {
        const std::size_t n = found.skipped.size();
        line += "; " + std::to_string(n) + (n == 1 ? " part" : " parts") + " skipped, named below";
    }
    if (outcome.status == Status::Fail) {
        if (!outcome.reason.empty()) line += "; " + outcome.reason;
        if (!found.faults.empty()) line += "; " + found.faults.front();
        if (found.largest_error > outcome.validator->tolerance) line += "; at " + found.where;
    }
    return line;
}

std::string JsonOf(const std::vector<Outcome>& outcomes) {
    std::string json = "{\"validators\": [";
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Outcome& o = outcomes[i];
        json += std::string(i ? "," : "") + "\n  {\"name\": " + Quoted(o.validator->name);
        json += ", \"status\": " + Quoted(NameOf(o.status));
        json += ", \"largest_error\": " + Number(o.findings.largest_error, "%.17g");
        json += ", \"tolerance\": " + Number(o.validator->tolerance, "%.17g");
        json += ", \"comparisons\": " + std::to_string(o.findings.n_compared);
        json += ", \"seconds\": " + Number(o.seconds, "%.3f");
        json += ",\n   \"checks\": " + Quoted(o.validator->checks);
        json += ",\n   \"where\": " + Quoted(o.findings.where) + ", \"reason\": " + Quoted(o.reason);
        json += ",\n   \"faults\": " + QuotedList(o.findings.faults);
        json += ",\n   \"skipped\": " + QuotedList(o.findings.skipped);
        json += ",\n   \"notes\": " + QuotedList(o.findings.notes) + "}";
    }
    return json + "\n]}\n";
}

std::string HtmlOf(const std::vector<Outcome>& outcomes) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>SolidSubdiv: validation</title>\n"
        "<style>body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}"
        "table{border-collapse:collapse;width:100%}td,th{text-align:left;padding:.3em .8em;border-bottom:1px solid "
        "#ddd}"
        ".PASS{color:#176b2c}.FAIL{color:#b00020;font-weight:bold}.SKIPPED{color:#8a5a00}li{font-size:90%}"
        "</style></head><body>\n<h1>SolidSubdiv: validation</h1>\n"
        "<p>Each line holds the framework to something that was not derived from it.</p>\n"
        "<table><tr><th>validator</th><th>result</th><th>largest error</th><th>may be</th><th>comparisons</th>"
        "<th>seconds</th></tr>\n";
    for (const Outcome& o : outcomes) {
        const std::string name = Escaped(o.validator->name), status(NameOf(o.status));
        html += "<tr><td><a href=\"#" + name + "\">" + name + "</a></td><td class=\"" + status + "\">" + status +
                "</td><td>" + (o.findings.n_compared ? Number(o.findings.largest_error) : "") + "</td><td>" +
                Number(o.validator->tolerance) + "</td><td>" + std::to_string(o.findings.n_compared) + "</td><td>" +
                Number(o.seconds, "%.1f") + "</td></tr>\n";
    }
    html += "</table>\n";
    for (const Outcome& o : outcomes) {
        const std::string name = Escaped(o.validator->name);
        html += "<h2 id=\"" + name + "\">" + name + "</h2>\n<p>" + Escaped(o.validator->checks) + ".</p>\n";
        html += "<p>Tolerance " + Number(o.validator->tolerance) + ": " + Escaped(o.validator->tolerance_reason) +
                ".</p>\n";
        if (!o.reason.empty()) html += "<p>" + Escaped(o.reason) + "</p>\n";
        if (!o.findings.where.empty()) html += "<p>Largest error at " + Escaped(o.findings.where) + ".</p>\n";
        html += HtmlList("Wrong:", o.findings.faults);
        html += HtmlList("Skipped:", o.findings.skipped);
        html += HtmlList("Figures:", o.findings.notes);
    }
    return html + "</body></html>\n";
}

}  // namespace SolidSubdiv::Validation

// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/published.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>

namespace riprap::run {

namespace {

constexpr std::array<std::string_view, 7> kinds{"section",  "figure",  "table", "equation",
                                                "appendix", "chapter", "test"};

std::string small(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
    return out;
}

/// Words of a text in small letters, without blanks and commas between them and marks around them.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : small(text) + " ") {
        if (std::string_view(" ,;()[]\"'").find(c) == std::string_view::npos) {
            word += c;
            continue;
        }
        word.erase(word.find_last_not_of(".:") + 1);
        if (!word.empty()) {
            words.push_back(word);
        }
        word.clear();
    }
    return words;
}

/// The kind that a word in small letters means: "fig.", "figs" and "figures" are "figure". Empty for any other word.
std::string_view kind_of(std::string_view word) {
    if (word.ends_with('.')) {
        word.remove_suffix(1);
    }
    if (word.ends_with('s')) {
        word.remove_suffix(1);
    }
    const auto found = std::find_if(kinds.begin(), kinds.end(), [word](std::string_view kind) {
        return word.size() >= 3 && kind.starts_with(word);
    });
    return found == kinds.end() ? std::string_view() : *found;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// True for "7.13", "12", "b1" and "12a".
bool is_number(std::string_view word) {
    return !word.empty() && (is_digit(word[0]) || (word.size() > 1 && is_digit(word[1]) && std::isalpha(word[0]) != 0));
}

/// A number apart from what comes before its last digits: "7.13" is {"7.", 13}; letters behind it are parts of a
/// figure and left out.
struct Split {
    std::string_view front;
    int last;
};

Split split(std::string_view number) {
    while (!number.empty() && !is_digit(number.back())) {
        number.remove_suffix(1);
    }
    std::size_t digits = number.size();
    while (digits > 0 && is_digit(number[digits - 1])) {
        --digits;
    }
    return {number.substr(0, digits), std::atoi(std::string(number.substr(digits)).c_str())};
}

bool is_between(std::string_view first, std::string_view number, std::string_view last) {
    const Split a = split(first), b = split(number), c = split(last);
    return a.front == b.front && b.front == c.front && a.last <= b.last && b.last <= c.last;
}

/// True for the same number, and for a section within the one asked for: 7.2.3 for 7.2.
bool is_within(std::string_view found, std::string_view number) {
    const bool is_longer = found.size() > number.size() && found.starts_with(number) && found[number.size()] == '.';
    return is_longer || is_between(found, number, found);
}

std::vector<std::string> parts_of(const std::string& source) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= source.size();) {
        const std::size_t end = std::min(source.find(';', begin), source.size());
        parts.push_back(source.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Tells whether a number, or a word such as "3d", is one of these or, with its letters, part of one.
bool stands_in(const std::vector<std::string>& tokens, const std::string& word) {
    const bool has_letter = word.find_first_not_of("0123456789.") != std::string::npos;
    return std::any_of(tokens.begin(), tokens.end(), [&](const std::string& token) {
        return token == word || (has_letter && token.find(word) != std::string::npos);
    });
}

/// Tells whether all words are about a case of which `part` is the publication meant.
bool is_about_part(const std::string& text, const std::string& part, const std::vector<std::string>& words) {
    const std::vector<std::string> tokens = words_of(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view kind = kind_of(words[i]);
        if (!kind.empty() && i + 1 < words.size() && is_number(words[i + 1])) {
            if (!names_number(part, kind, words[++i])) {
                return false;
            }
        } else if (is_number(words[i])) {
            if (!stands_in(tokens, words[i]) && !names_number(part, "", words[i])) {
                return false;
            }
        } else if (text.find(kind.empty() ? words[i] : std::string(kind)) == std::string::npos) {
            return false;
        }
    }
    return true;
}

/// Sources that a case file cites, in its order; read line by line, as a listing must not fail on a case.
std::vector<std::string> citations_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::string> found;
    for (std::string line; std::getline(in, line);) {
        const std::size_t begin = line.find('"'), end = line.rfind('"');
        if (line.starts_with("citation") && begin < end) {
            const std::string citation = line.substr(begin + 1, end - begin - 1);
            if (std::find(found.begin(), found.end(), citation) == found.end()) {
                found.push_back(citation);
            }
        }
    }
    return found;
}

}  // namespace

std::vector<PublishedCase> published_cases() {
    std::vector<PublishedCase> cases;
    for (KnownCase& known : known_cases("validation")) {
        PublishedCase published{std::move(known), {}};
        published.citations = citations_of(published.file);
        if (!published.source.empty() || !published.citations.empty()) {
            cases.push_back(std::move(published));
        }
    }
    return cases;
}

bool names_number(std::string_view source, std::string_view kind, std::string_view number) {
    const std::string wanted = small(number);
    const std::string_view wanted_kind = kind_of(small(kind));
    std::string_view current;
    std::string before;
    bool is_range = false;
    const std::vector<std::string> words = words_of(source);
    for (const std::string& word : words) {
        if (is_number(word) && !current.empty()) {
            const bool is_kind =
                kind.empty() || current == wanted_kind || (wanted_kind == "chapter" && current == "section");
            if (is_kind && (is_within(word, wanted) || (is_range && is_between(before, wanted, word)))) {
                return true;
            }
            before = word;
        } else if (word != "and" && word != "to") {
            current = kind_of(word);
        }
        is_range = word == "to";
    }
    return false;
}

bool is_about(const PublishedCase& published, const std::vector<std::string>& words) {
    std::string whole = published.name + " " + published.title;
    for (const std::string& citation : published.citations) {
        whole += " " + citation;
    }
    std::vector<std::string> wanted;
    for (const std::string& word : words) {  // "ding figure 7.13" may come as one
        for (const std::string& one : words_of(word)) {
            wanted.push_back(one);
        }
    }
    const std::vector<std::string> parts = parts_of(published.source);
    return std::any_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return is_about_part(small(whole + " " + part), part, wanted); });
}

}  // namespace riprap::run

// Which word did the user mean?
#pragma once
#include <span>
#include <string>
#include <vector>

namespace pmr::casefile {

// Edits (insert, delete, replace, swap neighbours) from one word to the other [1]; Damerau 1964.
std::size_t edit_distance(const std::string& a, const std::string& b);

// The candidate with the fewest edits, or "" where all are too far to be meant.
std::string nearest(const std::string& word, std::span<const std::string> candidates);

// "'diametr' is unknown; did you mean 'diameter'?", or the list of candidates.
std::string unknown_word(const std::string& kind, const std::string& word,
                         std::span<const std::string> candidates);

}  // namespace pmr::casefile

/// @file
/// Catch2, whichever version is there, with GLM vectors printed as vectors.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <string>

using Catch::Approx;

namespace Catch {

template <glm::length_t N, class T, glm::qualifier Q>
struct StringMaker<glm::vec<N, T, Q>> {
  static std::string convert(const glm::vec<N, T, Q>& v) {
    std::ostringstream text;
    text.precision(9);
    text << '(';
    for (glm::length_t i = 0; i < N; ++i)
      text << (i ? ", " : "") << v[i];
    text << ')';
    return text.str();
  }
};

}  // namespace Catch

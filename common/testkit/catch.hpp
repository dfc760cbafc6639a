/// @file
/// Catch2, whichever version is there, with GLM's vectors and quaternions printed as numbers.
/// Matchers are left out: versions 2 and 3 name them differently.
#pragma once

#if __has_include(<catch2/catch_test_macros.hpp>)
// Version 3. Its library may be compiled as C++14, without the body that prints a string_view.
#ifndef CATCH_CONFIG_NO_CPP17_STRING_VIEW
#define CATCH_CONFIG_NO_CPP17_STRING_VIEW
#endif
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/catch_translate_exception.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>  // has Approx without a namespace
#endif

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <string>

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

template <class T, glm::qualifier Q>
struct StringMaker<glm::qua<T, Q>> {
  static std::string convert(const glm::qua<T, Q>& q) {
    std::ostringstream text;
    text.precision(9);
    text << "(w " << q.w << ", " << q.x << ", " << q.y << ", " << q.z << ')';
    return text.str();
  }
};

}  // namespace Catch

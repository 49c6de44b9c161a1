// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_CHECK_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_CHECK_H

// Checks that NDEBUG does not remove, unlike assert(). A failed one is reported and counted, and the test goes on.
//
//   CHECK(condition);
//   CHECK_MESSAGE(condition, message);          // anything that can be streamed, shown if the check fails
//   CHECK_THROWS_AS(expression, Exception);     // commas outside of parentheses ask for parentheses around it
//   CHECK_THROWS_AS(expression, Exception, text);  // and what() contains the text
//   int main() { ...; return result(); }

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

namespace checks {

inline std::size_t& number_of_checks()
{
  static std::size_t count = 0;
  return count;
}

inline std::size_t& number_of_failures()
{
  static std::size_t count = 0;
  return count;
}

inline void check(const bool holds, const std::string& what, const char* file, const int line)
{
  ++number_of_checks();
  if(holds)
    return;
  ++number_of_failures();
  std::cerr << file << ":" << line << ": check failed: " << what << std::endl;
}

// Tells why `call` does not throw an `Exception` whose what() contains `text`; an empty string if it does.
template <class Exception, class Call>
std::string complaint_about_exception(const Call& call, const std::string& text)
{
  try
  {
    call();
  }
  catch(const Exception& e)
  {
    const std::string what = e.what();
    return what.find(text) != std::string::npos ? "" : "the message lacks \"" + text + "\": " + what;
  }
  catch(const std::exception& e)
  {
    return std::string("threw another exception: ") + e.what();
  }
  catch(...)
  {
    return "threw something that is not a std::exception";
  }
  return "threw nothing";
}

} // namespace checks

#define CHECK(...) checks::check(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

#define CHECK_MESSAGE(condition, message)                                                         \
  do                                                                                              \
  {                                                                                               \
    const bool check_holds = static_cast<bool>(condition);                                        \
    std::ostringstream check_message;                                                             \
    if(!check_holds)                                                                              \
      check_message << #condition << ": " << message;                                             \
    checks::check(check_holds, check_message.str(), __FILE__, __LINE__);                          \
  } while(false)

#define CHECK_THROWS_WITH_TEXT(expression, Exception, text)                                       \
  do                                                                                              \
  {                                                                                               \
    const std::string check_complaint =                                                           \
      checks::complaint_about_exception<Exception>([&]() { (void)(expression); }, text);          \
    checks::check(check_complaint.empty(), #expression " " + check_complaint, __FILE__, __LINE__); \
  } while(false)

#define CHECK_THROWS_WITH_ANY_TEXT(expression, Exception) CHECK_THROWS_WITH_TEXT(expression, Exception, "")

// Two or three arguments: they push the macro that takes as many to the fourth place.
#define CHECK_SELECT_FOURTH(first, second, third, fourth, ...) fourth
#define CHECK_THROWS_AS(...)                                                                      \
  CHECK_SELECT_FOURTH(__VA_ARGS__, CHECK_THROWS_WITH_TEXT, CHECK_THROWS_WITH_ANY_TEXT, unused)(__VA_ARGS__)

// What main() returns: a test that checked nothing did not pass either.
inline int result()
{
  const bool passed = checks::number_of_failures() == 0 && checks::number_of_checks() > 0;
  std::cerr << checks::number_of_checks() - checks::number_of_failures() << " of " << checks::number_of_checks()
            << " checks passed" << std::endl;
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_CHECK_H

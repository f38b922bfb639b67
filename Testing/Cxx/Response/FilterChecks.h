// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_FilterChecks_h
#define palpate_testing_FilterChecks_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

/// Counts a failure and continues. The test returns palpate::testing::result().
#define PALPATE_CHECK(condition)                                                                   \
  palpate::testing::check((condition), #condition, std::string(), __FILE__, __LINE__)
/// Requires |actual - expected| <= tolerance; never true for NaN.
#define PALPATE_CHECK_NEAR(actual, expected, tolerance)                                            \
  palpate::testing::checkNear((actual), (expected), (tolerance), #actual, __FILE__, __LINE__)
/// Requires that the text contains every one of the given words.
#define PALPATE_CHECK_TEXT(text, ...)                                                              \
  palpate::testing::checkText((text), { __VA_ARGS__ }, __FILE__, __LINE__)

namespace palpate::testing
{
inline int& failures()
{
  static int count = 0;
  return count;
}

inline int result()
{
  return failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

inline void check(
  bool good, const char* condition, const std::string& remark, const char* file, int line)
{
  if (!good && ++failures() <= 20) // prints the first 20 failures only
  {
    std::cerr << file << ":" << line << ": failed: " << condition << remark << std::endl;
  }
}

inline void checkNear(double actual, double expected, double tolerance, const char* expression,
  const char* file, int line)
{
  const bool good = std::abs(actual - expected) <= tolerance;
  std::string remark;
  if (!good)
  {
    char text[200];
    std::snprintf(text, sizeof text, " is %.17g instead of %.17g, off by %.3g > %.3g", actual,
      expected, actual - expected, tolerance);
    remark = text;
  }
  check(good, expression, remark, file, line);
}

inline void checkText(
  const std::string& text, std::initializer_list<const char*> words, const char* file, int line)
{
  for (const char* word : words)
  {
    check(text.find(word) != std::string::npos, "message",
      " lacks '" + std::string(word) + "': \"" + text + "\"", file, line);
  }
}

/// Captures the messages of an object and the executive's own error message during its lifetime.
class Messages
{
public:
  explicit Messages(vtkObject* object) { listen(object, this->Own); }
  explicit Messages(vtkAlgorithm* algorithm)
  {
    listen(algorithm, this->Own);
    listen(algorithm->GetExecutive(), this->Executive);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  std::string errors() const { return this->Own->GetErrorMessage(); }
  std::string warnings() const { return this->Own->GetWarningMessage(); }
  /// True if there was no error and no warning.
  bool none() const
  {
    return !this->Own->GetError() && !this->Own->GetWarning() && !this->Executive->GetError();
  }
  void clear()
  {
    this->Own->Clear();
    this->Executive->Clear();
  }
  /// Returns the errors since the last call.
  std::string takeErrors()
  {
    const std::string text = this->errors();
    this->clear();
    return text;
  }

private:
  using Observer = vtkSmartPointer<vtkTest::ErrorObserver>;
  static void listen(vtkObject* object, vtkTest::ErrorObserver* observer)
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }

  Observer Own = Observer::New();
  Observer Executive = Observer::New();
};

/// During the lifetime of this object a filter is aborted once its progress exceeds a fraction.
class AbortAfter
{
public:
  AbortAfter(vtkAlgorithm* filter, double progress)
    : Filter(filter)
    , Progress(progress)
  {
    this->Observer->SetClientData(&this->Progress);
    this->Observer->SetCallback(
      [](vtkObject* caller, unsigned long, void* limit, void* progress)
      {
        if (*static_cast<double*>(progress) > *static_cast<double*>(limit))
        {
          static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
        }
      });
    this->Tag = filter->AddObserver(vtkCommand::ProgressEvent, this->Observer);
  }
  ~AbortAfter() { this->Filter->RemoveObserver(this->Tag); }
  AbortAfter(const AbortAfter&) = delete;
  AbortAfter& operator=(const AbortAfter&) = delete;

private:
  vtkAlgorithm* Filter;
  double Progress;
  vtkNew<vtkCallbackCommand> Observer;
  unsigned long Tag;
};

/// Runs `work` with this number of threads. With the Sequential back end, the default of some VTK
/// builds, the number of threads would have no effect.
template <class Work>
void withThreads(int threads, const Work& work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, work);
}
} // namespace palpate::testing

#endif

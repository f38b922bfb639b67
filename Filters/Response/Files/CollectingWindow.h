// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CollectingWindow_h
#define palpate_CollectingWindow_h

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <regex>
#include <string>
#include <vector>

namespace palpate
{
/** Collects errors and warnings instead of showing them. */
class CollectingWindow : public vtkOutputWindow
{
public:
  static CollectingWindow* New() { VTK_STANDARD_NEW_BODY(CollectingWindow); }
  vtkTypeMacro(CollectingWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayWarningText(const char* text) override { this->warn(text); }
  void DisplayGenericWarningText(const char* text) override { this->warn(text); }
  void DisplayErrorText(const char* text) override
  {
    const std::string all = text;
    if (all.find("Error reading InformationKey") != std::string::npos)
    {
      return; // an array contains NaN; only the range of its values is missing
    }
    this->failed = true;
    if (this->error.empty() &&
      // This message adds no information to the first error.
      all.find("returned failure for request") == std::string::npos)
    {
      this->error = messageOf(all);
    }
  }

  bool hasFailed() const { return this->failed; }
  /** Returns the first error or, if there are no errors, the first warning. */
  std::string reason() const { return this->error.empty() ? this->firstWarning() : this->error; }
  std::string firstWarning() const
  {
    return this->different.empty() ? std::string() : this->different.front();
  }
  /** Prints the first few warnings, in order and without repetition. */
  void printWarnings() const
  {
    for (const std::string& warning : this->different)
    {
      std::fprintf(stderr, "palpate: warning: %s\n", warning.c_str());
    }
  }

private:
  /** Stores a warning. Some readers report an error as a warning and continue. */
  void warn(const std::string& text)
  {
    // The word boundary excludes names of arrays that end with "Error".
    static const std::regex isError("\\bError\\b");
    this->failed = this->failed || std::regex_search(text, isError);
    const std::string message = messageOf(text);
    if (this->different.size() < MostWarnings &&
      std::find(this->different.begin(), this->different.end(), message) == this->different.end())
    {
      this->different.push_back(message);
    }
  }

  /**
   * Extracts the message from the text "ERROR: In file, line n
   * class (address): message
   *
   * ", because VTK passes only the whole text.
   */
  static std::string messageOf(const std::string& text)
  {
    const std::size_t address = text.find("): ");
    const std::size_t line = text.find('\n');
    std::string message = address != std::string::npos ? text.substr(address + 3)
      : line != std::string::npos                      ? text.substr(line + 1)
                                                       : text;
    std::replace(message.begin(), message.end(), '\n', ' ');
    message.erase(message.find_last_not_of(" .") + 1);
    return message;
  }

  static constexpr std::size_t MostWarnings = 8;

  bool failed = false;
  std::string error;
  /// The different warnings, in the order of their first occurrence.
  std::vector<std::string> different;
};

/**
 * During the lifetime of this object, VTK's output goes to a CollectingWindow instead of the
 * console.
 */
struct QuietScope
{
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkNew<CollectingWindow> window;

  QuietScope()
  {
    vtkOutputWindow::SetInstance(this->window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~QuietScope()
  {
    vtkLogger::SetStderrVerbosity(this->verbosity);
    vtkOutputWindow::SetInstance(this->before);
  }
  QuietScope(const QuietScope&) = delete;
  QuietScope& operator=(const QuietScope&) = delete;
};
} // namespace palpate

#endif

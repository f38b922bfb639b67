// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSessionFiles
 * @brief pictures of the window and records of the session, under names of their own
 *
 * Files are "palpate-1.png", "palpate-1.csv" in OutputFolder, the first number that is free, unless
 * they are given a name. A record is every tick between two moments of a session, as a trajectory
 * file that the device "replay:FILE" reads; it goes on over a stop and a start. GetNotice says, in
 * words, what was last done. For the session's thread.
 */
#ifndef vtkSessionFiles_h
#define vtkSessionFiles_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkHapticSession;
class vtkRenderWindow;

namespace palpate
{
class TickTape;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkSessionFiles : public vtkObject
{
public:
  static vtkSessionFiles* New();
  vtkTypeMacro(vtkSessionFiles, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The session that is recorded. */
  void SetSession(vtkHapticSession* session);
  /** The window that pictures are taken of. */
  void SetWindow(vtkRenderWindow* window);

  ///@{
  /** Where files without a name go. Made when needed. Default: the folder the program runs in. */
  vtkSetMacro(OutputFolder, std::string);
  vtkGetMacro(OutputFolder, std::string);
  ///@}
  ///@{
  /** What was last done, "picture palpate-1.png"; for whoever shows it. */
  vtkSetMacro(Notice, std::string);
  vtkGetMacro(Notice, std::string);
  ///@}

  /** Writes the window as a .png; "": under a name of its own. Returns the name of the file, ""
   * after an error. */
  std::string WritePicture(const std::string& fileName = std::string());

  ///@{
  /**
   * Keeps every tick from StartRecording on, then writes them; "": under a name of its own.
   * Starting returns false, after an error, unless the session's recorder had HistorySeconds of
   * some frames at its Start, 1 is plenty; writing returns the name of the file, "" after an error.
   * ToggleRecording does what is due.
   */
  bool StartRecording();
  std::string WriteRecording(const std::string& fileName = std::string());
  void ToggleRecording();
  bool IsRecording() const;
  ///@}
  /** Ticks kept since StartRecording. */
  vtkIdType GetNumberOfRecordedTicks() const;

protected:
  vtkSessionFiles();
  ~vtkSessionFiles() override;

private:
  vtkSessionFiles(const vtkSessionFiles&) = delete;
  void operator=(const vtkSessionFiles&) = delete;

  std::string FreeName(const char* ending);
  std::string Finish(const std::string& what, const std::string& name, const std::string& error);

  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::shared_ptr<palpate::TickTape> Tape; ///< of the session's recorder; null before a recording
  std::string OutputFolder;
  std::string Notice;
};

#endif

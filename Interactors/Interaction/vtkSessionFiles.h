// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSessionFiles
 * @brief writes pictures of the window and records of the session, under automatic names
 *
 * Files are named "palpate-1.png", "palpate-1.csv" in OutputFolder, with the first free number,
 * unless the caller gives a name. A record contains all ticks between two times of a session, as a
 * trajectory file for the device "replay:FILE". It continues over a stop and a start of the
 * session; the times of the later run follow those before. It names body, tool, material, model and
 * friction, and their changes. GetNotice describes the last action. Only the session's thread may
 * use it.
 *
 * @code{.py}
 * session.GetRecorder().SetHistorySeconds(1.0)         # before Start
 * files = palpate.vtkSessionFiles()
 * files.SetSession(session)
 * files.SetWindow(window)
 * files.SetOutputFolder("records")
 * files.StartRecording()                               # while the session runs
 * name = files.WriteRecording()                        # "records/palpate-1.csv"
 * @endcode
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

  /** The session whose ticks are recorded. */
  void SetSession(vtkHapticSession* session);
  /** The window whose pictures are written. */
  void SetWindow(vtkRenderWindow* window);

  ///@{
  /**
   * Folder for files without a given name. It is created if it does not exist. Default: the current
   * folder.
   */
  vtkSetMacro(OutputFolder, std::string);
  vtkGetMacro(OutputFolder, std::string);
  ///@}
  ///@{
  /** Description of the last action, such as "picture palpate-1.png", for display. */
  vtkSetMacro(Notice, std::string);
  vtkGetMacro(Notice, std::string);
  ///@}

  /**
   * Writes a picture of the window as a .png file. If `fileName` is "", the file gets an automatic
   * name. Returns the name of the file, or "" after an error.
   */
  std::string WritePicture(const std::string& fileName = std::string());

  ///@{
  /**
   * StartRecording begins to store all ticks. It returns false and reports an error if
   * HistorySeconds of the session's recorder was 0 at Start. HistorySeconds must cover a few
   * frames; 1 s is more than enough. WriteRecording writes the stored ticks to a file. If
   * `fileName` is "", the file gets an automatic name. It returns the name of the file, or "" after
   * an error. ToggleRecording starts a recording, or writes the recording that is in progress.
   */
  bool StartRecording();
  std::string WriteRecording(const std::string& fileName = std::string());
  void ToggleRecording();
  bool IsRecording() const;
  ///@}
  /** Number of ticks stored since StartRecording. */
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
  /// Tape of the session's recorder; null before a recording.
  std::shared_ptr<palpate::TickTape> Tape;
  std::string OutputFolder;
  std::string Notice;
};

#endif

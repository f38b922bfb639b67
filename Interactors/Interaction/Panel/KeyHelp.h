// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeyHelp_h
#define KeyHelp_h

#include "Interaction/Panel/PixelBox.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// A sheet in the middle of a renderer with the functions of keys and mouse, in two columns.
class KeyHelp
{
public:
  KeyHelp();
  ~KeyHelp();
  KeyHelp(const KeyHelp&) = delete;
  KeyHelp& operator=(const KeyHelp&) = delete;

  /// A line per key: "key<tab>what it does"; an empty line is a gap.
  void setText(const std::string& text);
  const std::string& text() const { return this->Text; }

  /// Shows it in a renderer, on top; null: hides it.
  void show(vtkRenderer* renderer);
  bool isShown() const { return this->Renderer != nullptr; }

private:
  /// Centres it in the present size of the window.
  void place();

  std::string Text;
  vtkSmartPointer<vtkTextActor> Keys;
  vtkSmartPointer<vtkTextActor> Meanings;
  PixelBox Sheet;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
};
} // namespace palpate

#endif

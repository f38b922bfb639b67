// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCaption_h
#define SceneCaption_h

#include "vtkSmartPointer.h"

#include <string>

class vtkTextActor;

namespace palpate
{
struct ShownContact;

/// The text in the corner of a scene. It consists of a title, the description of the contact and a
/// remark. Empty parts are omitted.
class SceneCaption
{
public:
  SceneCaption();
  ~SceneCaption();
  SceneCaption(const SceneCaption&) = delete;
  SceneCaption& operator=(const SceneCaption&) = delete;

  void setTitle(const std::string& title) { this->Title = title; }
  void setRemark(const std::string& remark) { this->Remark = remark; }
  /// Sets a text on the state of the session, which is shown below the contact.
  void setState(const std::string& state) { this->State = state; }
  /// Sets the description of the contact, which the next call of write() shows.
  void describe(const ShownContact& contact, const std::string& tool, double contactRadius,
    double exaggeration);
  /// Adds a line about another hand. To be called after describe().
  void addHand(int number, const ShownContact& contact);
  void describeNothing() { this->Contact.clear(); }

  /// Writes the text into a strip of the picture that is `width` pixels wide. Long lines are
  /// broken. In a narrow strip the font is smaller.
  void write(double width);
  /// Height of the text above the lower edge of the picture, pixels.
  double height() const { return this->Height; }

  vtkTextActor* actor() { return this->Actor; }

private:
  double Height = 0.0;
  std::string Title;
  std::string Contact;
  std::string State;
  std::string Remark;
  vtkSmartPointer<vtkTextActor> Actor;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactSettings.h"

#include "Contact/SettingTable.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkContactSettings);

vtkContactSettings::vtkContactSettings() = default;

vtkContactSettings::~vtkContactSettings() = default;

void vtkContactSettings::SetKernel(const palpate::ContactSettings& settings)
{
  this->Values = settings;
  this->Modified();
}

std::string vtkContactSettings::GetFault()
{
  return palpate::faultOfContact(this->Values).words();
}

void vtkContactSettings::GetTable(vtkTable* table)
{
  const auto add = [table](const char* name, auto array, auto value)
  {
    array->SetName(name);
    for (const palpate::SettingRow& row : palpate::SettingTable)
    {
      array->InsertNextValue(value(row));
    }
    table->AddColumn(array);
  };
  using Row = palpate::SettingRow;
  const auto words = [] { return vtkSmartPointer<vtkStringArray>::New(); };
  const auto numbers = [] { return vtkSmartPointer<vtkDoubleArray>::New(); };
  table->Initialize();
  add("Name", words(), [](const Row& row) { return row.text.name; });
  add("Unit", words(), [](const Row& row) { return row.text.unit; });
  add("Minimum", numbers(), [](const Row& row) { return row.range.least; });
  add("IncludesMinimum", vtkSmartPointer<vtkIntArray>::New(),
    [](const Row& row) { return row.range.includesLeast ? 1 : 0; });
  add("Maximum", numbers(), [](const Row& row) { return row.range.most; });
  add("Default", numbers(), [](const Row& row) { return row.usual(); });
  add("Values", words(),
    [](const Row& row)
    {
      std::string names;
      for (const palpate::SettingWord& word : row.words)
      {
        names += word.name ? (names.empty() ? "" : " ") + std::string(word.name) : std::string();
      }
      return names;
    });
  add("Help", words(), [](const Row& row) { return row.text.help; });
}

void vtkContactSettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const palpate::SettingRow& row : palpate::SettingTable)
  {
    os << indent << row.text.name << ": " << row.get(this->Values) << (*row.text.unit ? " " : "")
       << row.text.unit << "\n";
  }
}

#include "frontend/block_forms.h"

#include <array>

namespace arelem::frontend {

std::span<const BlockForm> blockForms() {
  static constexpr std::array forms{
      BlockForm{"DO/ variable = first, last [, step] ... ENDDO",
                "repeats what stands between; `step` is 1, or negative to count down. Not at all "
                "where `last` lies before `first`"},
      BlockForm{"IF (condition) THEN ... [ELSEIF (condition) THEN ...] [ELSE ...] ENDIF",
                "does the first part whose condition holds"},
      BlockForm{".LT. .LE. .EQ. .NE. .GE. .GT. .AND. .OR. .NOT.", "conditions"},
      BlockForm{"INCLUDE/ 'file'",
                "the statements of a file, sought beside the program and in the folders of `-I`"},
  };
  return forms;
}

std::string_view doForm() {
  return blockForms().front().syntax;
}

}  // namespace arelem::frontend

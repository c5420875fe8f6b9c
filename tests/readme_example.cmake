# Fails unless the C++ block of README is the example file.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(FIND "${readme}" "```cpp\n${example}```" position)
if(position EQUAL -1)
  message(FATAL_ERROR "${EXAMPLE} differs from the C++ block of ${README}")
endif()

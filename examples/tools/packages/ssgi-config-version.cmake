# The end of ssgi.h lists the changes of each version: before 1.0 a minor version may rename.
set(PACKAGE_VERSION "@VERSION@")
string(REGEX MATCH "^[0-9]+" _ssgi_major "@VERSION@")
if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
elseif(_ssgi_major GREATER 0 AND PACKAGE_FIND_VERSION_MAJOR EQUAL _ssgi_major
       AND PACKAGE_FIND_VERSION VERSION_LESS PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
unset(_ssgi_major)

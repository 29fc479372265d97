# SPDX-License-Identifier: GPL-3.0-or-later
# Debian asks for an address. There is no public one: who makes packages for others gives theirs, in
# this variable or as for Debian's own tools. An address in .invalid says that it is none (RFC 2606).
set(DEWPOINT_MAINTAINER "" CACHE STRING "Name and address in the packages: Name <user@host>")
set(maintainer "${DEWPOINT_MAINTAINER}")
if(NOT maintainer AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBEMAIL}")
  if(NOT maintainer MATCHES "<.*>" AND DEFINED ENV{DEBFULLNAME})
    set(maintainer "$ENV{DEBFULLNAME} <${maintainer}>")
  endif()
endif()
if(NOT maintainer)
  set(maintainer "The Dewpoint authors <no-address@dewpoint.invalid>")
endif()
if(NOT maintainer MATCHES "^[^<>]+ <[^<>@ ]+@[^<>@ ]+>$")
  message(FATAL_ERROR "The maintainer of the packages is '${maintainer}': 'Name <user@host>' is expected "
                      "in DEWPOINT_MAINTAINER, or in the environment variables DEBFULLNAME and DEBEMAIL")
endif()

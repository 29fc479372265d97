# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages, one for each component; script/package makes them. Libraries that a program
# needs are found by dpkg-shlibdeps; what cannot be found by it comes from packages.txt.
include(maintainer.cmake)

# The release that this is, as in the last column of packages.txt.
file(STRINGS /etc/os-release release REGEX "^(ID|VERSION_ID)=")
string(REGEX REPLACE "^.*;?ID=\"?([a-z]+)\"?.*$" "\\1" id "${release}")
string(REGEX REPLACE "^.*VERSION_ID=\"?([0-9.]+)\"?.*$" "\\1" number "${release}")
set(DEWPOINT_DISTRIBUTION ${id}-${number})

# dewpoint_packages_of(<variable> <purpose> <with versions>): rows of packages.txt
function(dewpoint_packages_of variable purpose versions)
  file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/packages.txt rows REGEX "^[a-z0-9].* ${purpose} ")
  set(packages)
  foreach(row IN LISTS rows)
    string(REGEX MATCH "^([^ ]+) +[a-z]+ +([^ ]+) *([^ ]*)" row "${row}")
    if(CMAKE_MATCH_3 AND NOT CMAKE_MATCH_3 STREQUAL DEWPOINT_DISTRIBUTION)
      continue()
    endif()
    if(versions)
      list(APPEND packages "${CMAKE_MATCH_1} (>= ${CMAKE_MATCH_2})")
    else()
      list(APPEND packages "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  set(${variable} "${packages}" PARENT_SCOPE)
endfunction()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/packages.txt)

# Whoever compiles against core needs the headers of its libraries, but none of the window's.
dewpoint_packages_of(headers build TRUE)
list(FILTER headers INCLUDE REGEX "^(lib.*|nlohmann-json3)-dev ")
list(FILTER headers EXCLUDE REGEX "^lib(qt6|vtk|qcustomplot|benchmark|cli11)")
list(JOIN headers ", " headers)
# What a window wants to have, but starts without; a server for tests is not among it.
dewpoint_packages_of(wanted run FALSE)
list(FILTER wanted EXCLUDE REGEX "^(xvfb|xauth|python3-.*)$")
# Live cameras need the plugins of GStreamer, with a window and without.
set(plugins ${wanted})
list(FILTER plugins INCLUDE REGEX "^gstreamer")
list(JOIN plugins ", " plugins)
list(JOIN wanted ", " wanted)

# The changelog as Debian writes it.
file(READ ${PROJECT_SOURCE_DIR}/docs/changelog.md text)
string(REGEX REPLACE "^.*\n## ${PROJECT_VERSION} [^\n]*\n+" "" text "${text}")
string(REGEX REPLACE "\n## .*" "" text "${text}")
string(REGEX REPLACE "\\[([^]]*)\\]\\([^)]*\\)" "\\1" text "${text}")
string(REGEX REPLACE "\n+$" "" text "${text}")
string(REGEX REPLACE "\n  " "\n    " text "\n${text}")
string(REPLACE "\n- " "\n  * " text "${text}")
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date -u -R -d ${release_date}
                OUTPUT_VARIABLE release_time OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# dewpoint_describe_package(<component> <package> <section> <one line> <more>)
function(dewpoint_describe_package component package section summary description)
  string(TOUPPER ${component} upper)
  set(folder ${made}/debian/${package})
  file(WRITE ${folder}/changelog
       "${package} (${PROJECT_VERSION}) unstable; urgency=medium\n${text}\n\n -- ${maintainer}  ${release_time}\n")
  add_custom_command(OUTPUT ${folder}/changelog.gz
                     COMMAND ${GZIP} -9nc ${folder}/changelog > ${folder}/changelog.gz
                     DEPENDS ${folder}/changelog VERBATIM)
  install(FILES ${folder}/changelog.gz copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
  set(installed ${installed} ${folder}/changelog.gz PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()

set(what "Dewpoint follows colored objects in three dimensions with two or more
calibrated cameras, live or in recordings, by particle filters, and writes
their paths with the uncertainty.")
set(CPACK_COMPONENTS_ALL)
if(TARGET dewpoint)
  dewpoint_describe_package(window dewpoint science "track colored objects in 3D with ordinary cameras"
    "${what}\nThis package has the window: camera views, bird's-eye view, plots,\ncalibration.")
  set(CPACK_DEBIAN_WINDOW_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "dewpoint-doc (= ${PROJECT_VERSION}), hicolor-icon-theme")
  set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "${wanted}")
  set(CPACK_DEBIAN_WINDOW_PACKAGE_SUGGESTS "dewpoint-cli")
endif()
dewpoint_describe_package(cli dewpoint-cli science "track colored objects in 3D on the command line"
  "${what}\nThis package has the command line, which needs neither a display nor Qt.")
set(CPACK_DEBIAN_CLI_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CLI_PACKAGE_RECOMMENDS "${plugins}")
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS "dewpoint, dewpoint-doc")
if(TARGET dewpoint_python)
  dewpoint_describe_package(python python3-dewpoint python "track colored objects in 3D from Python"
    "${what}\nThis package has the Python module dewpoint: projects, calibration and\ntracking, with NumPy arrays.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The module is compiled for one version of Python.
  string(REGEX REPLACE "^([0-9]+)\\..*" "\\1" major ${DEWPOINT_PYTHON_VERSION})
  string(REGEX REPLACE "^[0-9]+\\." "" minor ${DEWPOINT_PYTHON_VERSION})
  math(EXPR minor "${minor} + 1")
  dewpoint_packages_of(python run TRUE)
  list(FILTER python INCLUDE REGEX "^python3-")
  list(JOIN python ", " python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${DEWPOINT_PYTHON_VERSION}), python3 (<< ${major}.${minor}), ${python}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "dewpoint-doc")
endif()
dewpoint_describe_package(development libdewpoint-dev libdevel "libraries and headers to track objects in 3D"
  "${what}\nThis package has static libraries, headers and a CMake package for\nprograms of your own.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${headers}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "dewpoint-doc")
dewpoint_describe_package(documentation dewpoint-doc doc "manual of Dewpoint, which tracks objects in 3D"
  "${what}\nThis package has the manual, which the window opens with F1, and examples.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dewpoint)
set(CPACK_PACKAGE_VENDOR Dewpoint)
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)

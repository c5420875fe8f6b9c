# cpack: three Debian packages as Debian divides a library. `wristwise` runs by itself: the program
# holds the static library.
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(package_program wristwise)
set(package_library libwristwise${soversion})
set(package_development libwristwise-dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
set(CPACK_PACKAGE_CONTACT "wristwise developers <wristwise@lists.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # CPack would put it above each description
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "planner for arc-welding robots
Turns a weld seam into a smooth, collision-free joint trajectory that an
independent check has passed: a ladder graph searches the route, a continuous
optimisation irons it out. Writes CSV, JSON, a report for a browser, and
robot programs. With robots and problems to start from.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm)

set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "planner for arc-welding robots (shared library)
Turns a weld seam into a smooth, collision-free joint trajectory that an
independent check has passed. What programs that link wristwise need to run.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/triggers)

set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "planner for arc-welding robots (development files)
Headers, static library, CMake package, pkg-config file and examples of
wristwise. The suggested packages are needed by the static library only.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${package_library} (= ${PROJECT_VERSION}), libeigen3-dev (>= 3.4)")
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "libassimp-dev, libceres-dev, libconsole-bridge-dev, libfcl-dev, libfmt-dev, libnlopt-cxx-dev, "
  "libqhull-dev, libtinyxml-dev, liburdfdom-dev, libyaml-cpp-dev, zlib1g-dev")

# What only a Debian package holds: its licence and its changes, under Debian's names.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component program library development)
  set(package ${package_${component}})
  string(TOUPPER ${component} COMPONENT)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${COMPONENT}_FILE_NAME DEB-DEFAULT)
  set(CPACK_COMPONENT_${COMPONENT}_GROUP ${component})
  set(CPACK_COMPONENT_DEBIAN_${COMPONENT}_GROUP ${component})
  list(APPEND CPACK_COMPONENTS_ALL ${component} debian_${component})

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/debian/${package})
  configure_file(debian/changelog.in ${folder}/changelog @ONLY)
  execute_process(COMMAND gzip -9nf ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES debian/copyright ${folder}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT debian_${component} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)

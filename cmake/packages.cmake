# Debian packages: `cpack -G DEB` in a build with -DCMAKE_INSTALL_PREFIX=/usr writes
# one package for each component of install(). A description is a short line, then a
# paragraph in lines of at most 80 characters. tests/api/packages.sh holds the
# packages against lintian; exceptions are in cmake/debian/libmurk0.lintian-overrides.

set(CPACK_PACKAGE_CONTACT "murk maintainers <maintainers@users.noreply.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 0murk1) # sorts before a package 0.1.0-1 of Debian's own
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/compress.cmake)
set(murk_same_version "libmurk0 (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# the copyright file names the licences of all code that murk contains
file(READ THIRD-PARTY.md third_party)
configure_file(cmake/debian/copyright.in debian/copyright @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS THIRD-PARTY.md)
# the date is that of SOURCE_DATE_EPOCH where it is set
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/debian/changelog.in debian/changelog.Debian @ONLY)

# murk_package(NAME SECTION DESCRIPTION [ALL] [DEPENDS ...]): ALL for any architecture.
# Files of Debian alone are excluded from an installation without a package.
function(murk_package name section description)
    cmake_parse_arguments(PARSE_ARGV 3 arg "ALL" "DEPENDS" "")
    string(TOUPPER ${name} component)
    set(prefix CPACK_DEBIAN_${component})
    set(${prefix}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(${prefix}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(${prefix}_DESCRIPTION ${description} PARENT_SCOPE)
    set(${prefix}_PACKAGE_DEPENDS ${arg_DEPENDS} PARENT_SCOPE)
    if(arg_ALL)
        set(${prefix}_PACKAGE_ARCHITECTURE all PARENT_SCOPE)
    endif()
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${name} PARENT_SCOPE)
    set(documents ${CMAKE_INSTALL_DATADIR}/doc/${name})
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/copyright
        ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.Debian
        DESTINATION ${documents} COMPONENT ${name} EXCLUDE_FROM_ALL)
endfunction()

murk_package(murk science
"simulator of light in fog, smoke, rain and water
murk traces photons from lamps, sun and sky through surfaces and scattering
media, keeps them in photon maps, and places cameras and other sensors where
they see the most of the light. It also renders pictures and calibrates media
by measurements.")
murk_package(libmurk0 libs
"simulator of light in scattering media - shared library
libmurk simulates light in fog, smoke, rain and water, and places sensors in
it. This package contains the shared library.")
set(CPACK_DEBIAN_MURK_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBMURK0_PACKAGE_SHLIBDEPS ON)
# fonts of the pictures of murk check, and the modules for grids and fits
set(CPACK_DEBIAN_MURK_PACKAGE_DEPENDS "fonts-dejavu-core, ${murk_same_version}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIBMURK0_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/triggers)
install(FILES cmake/debian/libmurk0.lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
    RENAME libmurk0 COMPONENT libmurk0 EXCLUDE_FROM_ALL)
murk_package(libmurk-dev libdevel
"simulator of light in scattering media - development files
libmurk simulates light in fog, smoke, rain and water, and places sensors in
it. This package contains the header murk.h and the files by which CMake and
pkg-config find the library."
    DEPENDS ${murk_same_version})
murk_package(murk-doc doc
"simulator of light in scattering media - documentation
murk simulates light in fog, smoke, rain and water, and places sensors in it.
This package contains a guide for new users, the description of scene files
and media, as text and as HTML pages, and the example scenes."
    ALL)
set(documents ${CMAKE_INSTALL_DATADIR}/doc/murk-doc)
# links of README.md to files that no package has become plain text
file(READ README.md readme)
string(REGEX REPLACE "\\[([^]]+)\\]\\((src|tests|tools|python|[A-Z][A-Z-]*\\.?[a-z]*)(/[^)]*)?\\)" "\\1" readme "${readme}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/debian/README.md "${readme}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS README.md)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/README.md DESTINATION ${documents} COMPONENT murk-doc)
install(FILES CHANGELOG.md DESTINATION ${documents} RENAME changelog COMPONENT murk-doc)
install(FILES media/README.md DESTINATION ${documents}/media COMPONENT murk-doc)
install(DIRECTORY scenes DESTINATION ${documents} COMPONENT murk-doc)
install(DIRECTORY doc DESTINATION ${documents} COMPONENT murk-doc PATTERN man EXCLUDE)
# HTML pages, if their generator (tools/html) is there when files are installed
set(html ${CMAKE_CURRENT_BINARY_DIR}/html)
install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
        ${CMAKE_CURRENT_SOURCE_DIR}/tools/html ${html} --man ${man} RESULT_VARIABLE result)
    if(result EQUAL 77)
        file(REMOVE_RECURSE ${html})
    elseif(NOT result EQUAL 0)
        message(FATAL_ERROR \"tools/html: \${result}\")
    endif()" COMPONENT murk-doc)
install(DIRECTORY ${html} DESTINATION ${documents} COMPONENT murk-doc OPTIONAL)
if(MURK_PYTHON)
    murk_package(python3-murk python
"simulator of light in scattering media - Python module
murk simulates light in fog, smoke, rain and water, and places sensors in it.
This package contains the Python module, whose results are NumPy arrays."
        ALL DEPENDS "python3, python3-cffi, python3-numpy, ${murk_same_version}")
    set(CPACK_DEBIAN_PYTHON3-MURK_PACKAGE_SUGGESTS "python3-matplotlib, jupyter-notebook")
    set(CPACK_DEBIAN_PYTHON3-MURK_PACKAGE_CONTROL_EXTRA
        ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/postinst ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/prerm)
endif()
if(MURK_MPI)
    murk_package(murk-mpi science
"simulator of light in fog, smoke, rain and water - runs in many processes
murk simulates light in fog, smoke, rain and water, and places sensors in it.
This package contains the program murk-mpi, which divides the work of murk
among the processes that mpirun of Open MPI starts on one or more machines."
        # murk-reader of libmurk0 reads meshes and grids for ranks, which must not fork
        DEPENDS "murk (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), ${murk_same_version}, openmpi-bin")
    set(CPACK_DEBIAN_MURK-MPI_PACKAGE_SHLIBDEPS ON)
endif()
if(TARGET murk_netcdf)
    murk_package(murk-netcdf science
"simulator of light in fog, smoke, rain and water - NetCDF files
murk simulates light in fog, smoke, rain and water, and places sensors in it.
This package contains the program by which murk reads clouds and other fields
from NetCDF files."
        DEPENDS "${murk_same_version}")
    set(CPACK_DEBIAN_MURK-NETCDF_PACKAGE_SHLIBDEPS ON)
endif()
if(TARGET murk_gdal)
    murk_package(murk-gdal science
"simulator of light in fog, smoke, rain and water - GeoTIFF files
murk simulates light in fog, smoke, rain and water, and places sensors in it.
This package contains the program by which murk reads the elevation of the
ground from GeoTIFF files."
        DEPENDS "${murk_same_version}")
    set(CPACK_DEBIAN_MURK-GDAL_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)

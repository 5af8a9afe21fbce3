"""Names of CMake commands, as far as it matters whether they can make an executable or install a file."""

from __future__ import annotations

HARMLESS = frozenset(
    """
    add_compile_definitions add_compile_options add_definitions add_dependencies add_library add_link_options
    add_test break build_command cmake_dependent_option cmake_host_system_information
    cmake_minimum_required cmake_parse_arguments cmake_policy continue create_test_sourcelist define_property else elseif enable_language
    enable_testing endforeach endfunction endif endmacro endwhile export find_file find_library find_package find_path find_program
    fltk_wrap_ui foreach function get_cmake_property get_directory_property get_source_file_property get_test_property
    get_filename_component get_property get_target_property if include_directories include_external_msproject include_guard
    include_regular_expression link_directories link_libraries macro mark_as_advanced message option project return
    separate_arguments set set_directory_properties set_property set_source_files_properties set_target_properties set_tests_properties
    site_name source_group string list math file target_compile_definitions target_compile_features target_compile_options
    target_include_directories target_link_directories target_link_libraries target_link_options target_precompile_headers
    target_sources try_compile try_run unset variable_requires variable_watch while execute_process cmake_path
    remove remove_definitions
    catkin_package catkin_package_xml catkin_python_setup catkin_destinations catkin_metapackage catkin_workspace
    catkin_add_env_hooks catkin_add_nosetests catkin_download catkin_download_test_data
    catkin_filter_libraries_for_build_configuration catkin_run_tests_target catkin_add_test catkin_simple cs_add_library
    cs_add_targets_to_package cs_catkin_add_gtest cs_export cs_install
    add_message_files add_service_files add_action_files generate_messages generate_dynamic_reconfigure_options
    add_rostest roslaunch_add_file_check roslint_add_test roslint_cpp roslint_custom roslint_python
    class_loader_hide_library_symbols genmsg_message generate_export_header write_basic_package_version_file
    configure_package_config_file gencfg genaction gensrv genmsg
    cuda_add_library cuda_compile cuda_include_directories cuda_select_nvcc_arch_flags
    rosbuild_init rosbuild_genmsg rosbuild_gensrv rosbuild_add_library rosbuild_add_boost_directories rosbuild_link_boost
    rosbuild_add_compile_flags rosbuild_find_ros_package rosbuild_add_rostest rosbuild_add_pyunit rosbuild_add_roslaunch_check
    rosbuild_add_openmp_flags rosbuild_add_link_flags rosbuild_add_gtest_build_flags rosbuild_include rosbuild_check_for_sse
    git_describe get_git_head_revision set_package_properties feature_summary enable_coverage add_code_coverage
    protobuf_generate_cpp protobuf_generate_python find_dependency tf2_include xacro_add_files xacro_add_xacro_file
    xacro_install
    """.split()
)
"""Commands of CMake itself and of the usual ROS packages that make no executable and install no launch file."""

HARMLESS_PREFIXES = (
    "check_",
    "pkg_",
    "qt4_",
    "qt5_",
    "qt6_",
    "qt_",
    "find_package_",
    "ament_target_",
    "code_coverage",
    "setup_target_for_coverage",
)

CATKIN_WORDS = frozenset(
    """
    INCLUDE_DIRS LIBRARIES CATKIN_DEPENDS DEPENDS CFG_EXTRAS EXPORTED_TARGETS
    SKIP_CMAKE_CONFIG_GENERATION SKIP_PKG_CONFIG_GENERATION
    """.split()
)
"""Words that end a list in catkin_package()."""

INSTALL_WORDS = frozenset(
    """
    PROGRAMS FILES DIRECTORY TARGETS DESTINATION PERMISSIONS CONFIGURATIONS COMPONENT RENAME OPTIONAL EXCLUDE_FROM_ALL TYPE
    FILE_PERMISSIONS DIRECTORY_PERMISSIONS USE_SOURCE_PERMISSIONS MESSAGE_NEVER FILES_MATCHING PATTERN REGEX EXCLUDE
    COMMAND DEPENDS OUTPUT BYPRODUCTS WORKING_DIRECTORY COMMENT VERBATIM MAIN_DEPENDENCY ARGS IMPLICIT_DEPENDS APPEND
    """.split()
)
"""Words that end a list of paths in install() and add_custom_command()."""

COMPUTING = frozenset(("string", "math", "execute_process", "cmake_path", "separate_arguments"))
ASSIGNING = COMPUTING | {"set", "list", "file", "get_filename_component"}
COMPUTING_FIRST = frozenset(("get_target_property", "get_property", "option", "find_path", "find_file", "find_program"))
"""Commands that compute variables: of some the first argument alone."""

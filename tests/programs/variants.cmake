# Tests with the label variants in place of default: those that need device programs beyond the 60 of the default tests (host/docs/decisions/0041-programs-of-the-tests.md). Here they stand together, as GoogleTest
# filters for each test program; tyndall_test reads the list. `.ci/run` runs both labels.

# Kernels against the host in double. By default at 16 lanes, here at the other widths and what has features of its own: samplers, phase functions, density grids, single features.
foreach(width 0 1 2)
  list(APPEND TYNDALL_VARIANTS_pair_stage_test PairStage/AtEveryLaneWidth.*/${width})
  list(APPEND TYNDALL_VARIANTS_light_selection_test LightSelection/SelectionAtEveryLaneWidth.*/${width})
  list(APPEND TYNDALL_VARIANTS_point_lights_test PointLights/PointsAtEveryLaneWidth.*/${width})
endforeach()
list(APPEND TYNDALL_VARIANTS_pair_stage_test
  PairStage.ATileThatFillsNoWholePacketIsRefused PairStage.WidthsFourEightAndSixteenAgreeToAMillionth
  *.EverySampler* *.Row37* *.SamplingAndAccumulatingEqualsGathering/* *.SumsOfLobes* *.TheLargestPairIsFound/*)
list(APPEND TYNDALL_VARIANTS_light_selection_test
  *.DegenerateAndBrokenLightsDoNoHarm/* *.EveryCandidateCountsOnceOnAverage/* *.EveryLightCountsOnceOnAverage/* *.SamplingAndAccumulatingEqualsGathering/* *.SumsAgreeWithAllLightsAndTheEstimateHelps/*)
list(APPEND TYNDALL_VARIANTS_point_lights_test *.TouchingPairsAreFinite/*)
set(TYNDALL_VARIANTS_grid_pairs_test *)
set(TYNDALL_VARIANTS_feature_mask_test *)
set(TYNDALL_VARIANTS_hard_cases_renderer_test HardCases.Row23* HardCases.Row34* HardCases.Row35*)
set(TYNDALL_VARIANTS_device_list_test KernelSource.ABrokenBuild*)
set(TYNDALL_VARIANTS_test_tiling ConnectPairs.WalksThroughBoundaries*)

# Masks and programs of every shipped scene, and of scenes made for them.
set(TYNDALL_VARIANTS_test_masks HandMask.* Of/Mask.* Programs.* WrongMask.*)

# Whole renders. By default fog with and without occluders, light selection, points, beams and photons, a density grid.
foreach(scene backlit_smoke cornell_fog crossing_rays fog_and_slit forward_fog fruit_juice glass_of_juice glossy_medium plume six_vrls smoky_room turning_light)
  list(APPEND TYNDALL_VARIANTS_test_pipeline Of/ShippedScene.RendersWithAnEmptyLedger/${scene})
endforeach()
list(APPEND TYNDALL_VARIANTS_test_pipeline
  *.RendersWithAnEmptyLedgerByEverySamplerAndLaneWidth/* Of/Precisions.* Of/Sameness.*/NestedFog Of/Sameness.TheLaneWidthChangesRoundingOnly/*
  AgainstPathTracing.FogInABall* AgainstPathTracing.FrostedGlass* AgainstPathTracing.GlassBall* AgainstPathTracing.JuiceInAGlassBall AgainstPathTracing.MediaThatShareAFace AgainstPathTracing.NestedMedia
  AgainstPathTracing.ShortLightsInADensityGrid AgainstPathTracing.ThinHaze* All/ThickLights.* ClampedPoints.* ConstantGrid.OfAFile* DensityEstimation.GivesTheSameBytes* DisjointMedia.* EveryLightTest.*
  Lights/Selected.*/AmongCandidates Lights/Selected.*/DepthLimit Lights/Selected.*/Nested Lights/Selected.*/ShortLights PhaseFunctionsAgainstPathTracing.* PhotonBeams.ApproachPathTracingInADensityGrid
  PhotonBeams.ApproachPathTracingInNestedMediaWhenShort PhotonBeams.SingleAndDoubleScatteringAlone SamplesPerPair.* SegmentLength.* Selection.InADensityGrid* SmoothGlass.BeamsOfAPointThroughAPlate*
  SurfaceLights.* SurfaceLightsTest.* Unbiased/EveryLight.ADensityGrid* Unbiased/EveryLight.DoubleScatteringAlone/* Unbiased/EveryLight.FogAroundAnOccluder/0 Unbiased/EveryLight.NestedMedia*
  WhiteFurnaceOfTheWholeRenderer.*)
set(TYNDALL_VARIANTS_test_virtual_ray_light_images */i_*)

# The library with media and callbacks of its own; the default tests keep the photon tracer beside `tyndall render` and the C interface.
set(TYNDALL_VARIANTS_test_library LibraryScene.AGlowingMeshAndAGridRender LibraryLocale.ChangesNoByte)
set(TYNDALL_VARIANTS_test_library_backend Backend.LeavesShadowsToTheCaller Backend.MatchesQuadrature* Backend.TheCallersTransmittance* BackendLimits.* CBackend.ContainersAreThose* CBackend.GivesTheBytes* CBackend.RefusesWhat*
  Every/BackendFaults.*/Transmittance)

# Selftests and measurements of kernels at several lane widths.
set(TYNDALL_VARIANTS_test_throughput MeasuredKernels.RunOnADevice*)
set(TYNDALL_VARIANTS_test_bench_program BenchProgram.*)
set(TYNDALL_VARIANTS_test_program_faults CommaLocaleProgram.MeasuresIn*)
set(TYNDALL_VARIANTS_test_selftest FirstUseOfADevice.AFailureNames* FirstUseOfADevice.RunsAgainForAnother* Selftest.AWrongKernel*)

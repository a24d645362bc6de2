package org.phrenic.patient;

/**
 * From the voxels of a structure to its surface, as Villard, Bourne and Bello 2009 made their patients' meshes: windowed sinc, decimation, windowed sinc again.
 *
 * @param iterations of the first smoothing
 * @param passBand of both
 * @param kept share of the vertices that decimation leaves, above 0 to 1
 * @param boundVoxels how far decimation may lead from the smooth surface, in voxels
 * @param lastIterations of the second smoothing
 */
public record MeshingSteps(int iterations, double passBand, double kept, double boundVoxels, int lastIterations) {
    /** The paper's numbers (section 4.1): pass band 0.2, 50 %, 200 more iterations; the first count is VTK's usual 20. */
    public static final MeshingSteps PAPER = new MeshingSteps(20, 0.2, 0.5, 0.5, 200);

    public MeshingSteps {
        if (iterations < 1 || lastIterations < 1 || !(passBand > 0 && passBand < 2)) {
            throw new IllegalArgumentException("meshing with " + iterations + " and " + lastIterations
                    + " iterations and a pass band of " + passBand + ", expected at least 1 and above 0 to below 2");
        }
        if (!(kept > 0 && kept <= 1) || !(boundVoxels > 0)) {
            throw new IllegalArgumentException("meshing with " + kept + " of the vertices kept, within " + boundVoxels
                    + " voxels, expected above 0 to 1 and above 0");
        }
    }
}

package org.phrenic.patient;

/**
 * From the voxels of a structure to its surface, as Villard, Bourne and Bello 2009 made their patients' meshes:
 * windowed sinc, decimation, windowed sinc again.
 *
 * @param firstIterations of the first smoothing
 * @param passBand of both
 * @param keptFraction share of the vertices that decimation leaves, above 0 to 1
 * @param maxDeviationVoxels how far decimation may lead from the smooth surface, in voxels
 * @param secondIterations of the second smoothing
 */
public record MeshingSettings(
        int firstIterations, double passBand, double keptFraction, double maxDeviationVoxels, int secondIterations) {
    /**
     * The paper's numbers (section 4.1): pass band 0.2, 50 %, 200 more iterations; the first count is VTK's usual 20.
     */
    public static final MeshingSettings PAPER = new MeshingSettings(20, 0.2, 0.5, 0.5, 200);

    public MeshingSettings {
        if (firstIterations < 1 || secondIterations < 1 || !(passBand > 0 && passBand < 2)) {
            throw new IllegalArgumentException("meshing with " + firstIterations + " and " + secondIterations
                    + " iterations and a pass band of " + passBand + ", expected at least 1 and above 0 to below 2");
        }
        if (!(keptFraction > 0 && keptFraction <= 1) || !(maxDeviationVoxels > 0)) {
            throw new IllegalArgumentException("meshing with " + keptFraction + " of the vertices kept, within "
                    + maxDeviationVoxels + " voxels, expected above 0 to 1 and above 0");
        }
    }
}

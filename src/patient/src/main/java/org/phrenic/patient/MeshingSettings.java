package org.phrenic.patient;

/**
 * Settings of the meshing method of Villard, Bourne and Bello 2009: windowed sinc smoothing, decimation, and a second
 * windowed sinc smoothing.
 *
 * @param passBand pass band of both smoothings
 * @param keptFraction fraction of vertices kept by the decimation, in (0, 1]
 * @param maxDeviationVoxels maximum deviation of the decimated surface, in voxels
 */
public record MeshingSettings(
        int firstIterations, double passBand, double keptFraction, double maxDeviationVoxels, int secondIterations) {
    /**
     * Settings of the paper for a patient's diaphragm: pass band 0.2, 50 % of the vertices, 200 iterations of the
     * second smoothing. The 20 iterations of the first smoothing are VTK's default, and the limit of half a voxel is
     * Phrenic's.
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

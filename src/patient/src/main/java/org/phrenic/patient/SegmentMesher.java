package org.phrenic.patient;

import java.util.List;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.Decimator;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.mesh.edit.WindowedSincFilter;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.SurfaceNet;

/**
 * Makes surfaces of the parts of a volume. The first smoothing moves the net that neighbours share, so that up to there
 * they meet; decimation and what follows are each part's own, within the bound of the {@link MeshingSettings}. May be
 * used by several threads.
 */
public final class SegmentMesher {
    private static final int LEAST_VERTICES = 12;
    /**
     * A structure two or three voxels thick, such as a rib in a coarse scan, is a wave that the paper's pass band cuts
     * off: if more of its volume goes, the band of the second smoothing is doubled.
     */
    private static final double MOST_LOST = 0.03;

    private final SurfaceNet voxels;
    private final SurfaceNet smooth;
    private final MeshingSettings steps;
    private final double voxelMm;

    /** @param parts number of the part each label is, 0 for none */
    public SegmentMesher(LabelGrid grid, int[] parts, MeshingSettings steps) {
        voxels = SurfaceNet.of(grid, parts);
        smooth = voxels.smoothed(steps.firstIterations(), steps.passBand());
        this.steps = steps;
        voxelMm = Math.cbrt(grid.voxelVolume());
    }

    /**
     * The surface of one part.
     *
     * @param edgeMm edge of its triangles, mm; 0 leaves those of the decimation
     * @throws IllegalArgumentException if the volume has no such part
     */
    public MeshedSegment mesh(int part, double edgeMm) {
        TriangleMesh label = largest(voxels.surface(part));
        List<TriangleMesh> shells = ConnectedComponents.of(smooth.surface(part));
        TriangleMesh whole = shells.get(indexOfLargest(shells));
        double leftOut = 0;
        for (TriangleMesh shell : shells) {
            leftOut += shell == whole ? 0 : Math.abs(MeshMeasure.signedVolume(shell));
        }
        int wanted = Math.max(LEAST_VERTICES, (int) Math.round(steps.keptFraction() * whole.vertexCount()));
        TriangleMesh few = Decimator.toVertexCount(whole, wanted, steps.maxDeviationVoxels() * voxelMm);
        double passBand = steps.passBand();
        TriangleMesh mesh = WindowedSincFilter.smooth(few, steps.secondIterations(), passBand);
        while (lost(mesh, whole) > MOST_LOST && 2 * passBand < 2) {
            passBand *= 2;
            mesh = WindowedSincFilter.smooth(few, steps.secondIterations(), passBand);
        }
        if (edgeMm > 0) {
            mesh = Remesher.toEdgeLength(mesh, edgeMm);
        }
        return new MeshedSegment(
                mesh,
                label.vertexCount(),
                few.vertexCount(),
                SurfaceComparison.summaryByArea(mesh, label),
                MeshQuality.of(mesh),
                passBand,
                shells.size(),
                leftOut);
    }

    private static double lost(TriangleMesh mesh, TriangleMesh of) {
        double volume = MeshMeasure.signedVolume(of);
        return Math.abs(MeshMeasure.signedVolume(mesh) - volume) / volume;
    }

    private static TriangleMesh largest(TriangleMesh surface) {
        List<TriangleMesh> shells = ConnectedComponents.of(surface);
        if (shells.isEmpty()) {
            throw new IllegalArgumentException("found no voxel of the part, expected some");
        }
        return shells.get(indexOfLargest(shells));
    }

    private static int indexOfLargest(List<TriangleMesh> shells) {
        int largest = 0;
        double most = 0;
        for (int i = 0; i < shells.size(); i++) {
            double volume = MeshMeasure.signedVolume(shells.get(i));
            if (volume > most) {
                most = volume;
                largest = i;
            }
        }
        return largest;
    }
}

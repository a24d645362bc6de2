package org.phrenic.patient;

import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.Decimator;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.mesh.edit.WindowedSincFilter;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.SurfaceNet;

/**
 * Meshes the segments of a volume with the steps of {@link MeshingSettings}. The first smoothing acts on the surface
 * net that neighbouring segments share, so adjacent surfaces still match. Decimation and the second smoothing are
 * applied to each segment separately. Thread-safe.
 */
public final class SegmentMesher {
    private static final int MIN_VERTICES = 12;

    /**
     * Maximum relative volume loss of the second smoothing. The pass band of the paper removes structures that are two
     * or three voxels thick, such as ribs in a coarse scan. If the loss is larger, the band is doubled.
     */
    private static final double MAX_VOLUME_LOSS = 0.03;

    private final SurfaceNet voxels;
    private final SurfaceNet smooth;
    private final MeshingSettings settings;
    private final double voxelMm;

    /** @param segments segment number of each label; 0 for no segment */
    public SegmentMesher(LabelGrid grid, int[] segments, MeshingSettings settings) {
        voxels = SurfaceNet.of(grid, segments);
        smooth = voxels.smoothed(settings.firstIterations(), settings.passBand());
        this.settings = settings;
        voxelMm = StrictMath.cbrt(grid.voxelVolume());
    }

    /**
     * Meshes one segment.
     *
     * @param edgeMm target edge length, mm; 0 keeps the triangles of the decimation
     * @throws IllegalArgumentException if the volume does not contain the segment
     */
    public MeshedSegment mesh(int segment, double edgeMm) {
        TriangleMesh label = largest(ConnectedComponents.of(voxels.surface(segment)));
        List<TriangleMesh> shells = ConnectedComponents.of(smooth.surface(segment));
        return mesh(label, largest(shells), shells, edgeMm);
    }

    /** Meshes all pieces of a segment, like {@link #mesh(int, double)}. Cavities are left out. */
    public MeshedSegment meshAll(int segment, double edgeMm) {
        List<TriangleMesh> shells = ConnectedComponents.of(smooth.surface(segment));
        return mesh(pieces(ConnectedComponents.of(voxels.surface(segment))), pieces(shells), shells, edgeMm);
    }

    /** Only the surface of {@link #mesh(int, double)}, not compared with the voxels, which is faster. */
    public TriangleMesh surface(int segment, double edgeMm) {
        return surface(segment, edgeMm, piece -> false);
    }

    /** The same with those of the other pieces that are wanted. */
    TriangleMesh surface(int segment, double edgeMm, Predicate<TriangleMesh> wanted) {
        List<TriangleMesh> shells = ConnectedComponents.of(smooth.surface(segment));
        TriangleMesh largest = largest(shells);
        List<TriangleMesh> taken = shells.stream()
                .filter(shell -> shell == largest || wanted.test(shell))
                .toList();
        return meshed(taken.size() == 1 ? largest : MeshMerge.merge(taken), edgeMm)
                .mesh();
    }

    /** Only the surface of {@link #meshAll(int, double)}, not compared with the voxels, which is faster. */
    TriangleMesh surfaceOfAll(int segment, double edgeMm) {
        return meshed(pieces(ConnectedComponents.of(smooth.surface(segment))), edgeMm)
                .mesh();
    }

    private static TriangleMesh pieces(List<TriangleMesh> shells) {
        return shells.size() == 1
                ? shells.get(0)
                : MeshMerge.merge(shells.stream()
                        .filter(shell -> MeshMeasure.signedVolume(shell) > 0)
                        .toList());
    }

    private MeshedSegment mesh(TriangleMesh label, TriangleMesh whole, List<TriangleMesh> shells, double edgeMm) {
        // Shells of cavities have negative volumes.
        double[] pieces = shells.stream()
                .mapToDouble(MeshMeasure::signedVolume)
                .filter(volume -> volume > 0)
                .toArray();
        double discarded = DoubleStream.of(pieces).sum() - MeshMeasure.signedVolume(whole);
        Meshed made = meshed(whole, edgeMm);
        return new MeshedSegment(
                made.mesh(),
                label.vertexCount(),
                made.decimatedVertices(),
                SurfaceComparison.summaryByArea(made.mesh(), label),
                MeshQuality.of(made.mesh()),
                made.passBand(),
                pieces.length,
                discarded);
    }

    /** @param passBand pass band of the second smoothing */
    private record Meshed(TriangleMesh mesh, int decimatedVertices, double passBand) {}

    private Meshed meshed(TriangleMesh whole, double edgeMm) {
        int wanted = Math.max(MIN_VERTICES, (int) Math.round(settings.keptFraction() * whole.vertexCount()));
        TriangleMesh few = Decimator.toVertexCount(whole, wanted, settings.maxDeviationVoxels() * voxelMm);
        double passBand = settings.passBand();
        TriangleMesh mesh = WindowedSincFilter.smooth(few, settings.secondIterations(), passBand);
        while (lost(mesh, whole) > MAX_VOLUME_LOSS && 2 * passBand < 2) {
            passBand *= 2;
            mesh = WindowedSincFilter.smooth(few, settings.secondIterations(), passBand);
        }
        if (edgeMm > 0) {
            mesh = Remesher.toEdgeLength(mesh, edgeMm);
        }
        return new Meshed(mesh, few.vertexCount(), passBand);
    }

    private static double lost(TriangleMesh mesh, TriangleMesh of) {
        double volume = MeshMeasure.signedVolume(of);
        return Math.abs(MeshMeasure.signedVolume(mesh) - volume) / volume;
    }

    private static TriangleMesh largest(List<TriangleMesh> shells) {
        return shells.stream()
                .max(Comparator.comparingDouble(MeshMeasure::signedVolume))
                .orElseThrow(() -> new IllegalArgumentException("found no voxel of the segment, expected some"));
    }
}

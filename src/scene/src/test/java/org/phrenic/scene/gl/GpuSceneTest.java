package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class GpuSceneTest {
    /** Such as while a scan is imported: the view goes on. */
    @Test
    void aSurfaceForWhoseFewerTrianglesMemoryLacksKeepsAll() {
        TriangleMesh sphere = Shapes.sphere(50, 2);
        int[] kept = GpuScene.fewerTriangles("liver", sphere, mesh -> {
            throw new OutOfMemoryError("Java heap space");
        });
        assertThat(kept).isEqualTo(sphere.triangles());
    }
}

package org.phrenic.study.sweep.run;

/** Connects to a cluster; found by {@link java.util.ServiceLoader} where the cluster module is on the class path. */
public interface ClusterService {
    /**
     * Connects to a cluster.
     *
     * @param master URL of its master, such as {@code local[2]} or {@code spark://head:7077}
     * @throws org.phrenic.file.BadInputException with one sentence, if there is no such master
     */
    SweepExecutor connect(String master);
}

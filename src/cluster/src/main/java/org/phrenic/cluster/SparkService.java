package org.phrenic.cluster;

import org.apache.spark.SparkConf;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaSparkContext;
import org.phrenic.file.BadInputException;
import org.phrenic.study.sweep.run.ClusterService;
import org.phrenic.study.sweep.run.SweepExecutor;

/**
 * Connects to a Spark master. Settings of Spark come from {@code spark-submit} or system properties {@code spark.*}.
 */
public final class SparkService implements ClusterService {
    /** Attempts of a task; each lost executor takes one. */
    private static final String ATTEMPTS = "16";

    @Override
    public SweepExecutor connect(String master) {
        SparkConf conf = new SparkConf().setAppName("phrenic sweep").setMaster(master);
        conf.setIfMissing("spark.task.maxFailures", ATTEMPTS);
        if (master.startsWith("local")) {
            conf.setIfMissing("spark.ui.enabled", "false");
        }
        try {
            JavaSparkContext context = new JavaSparkContext(conf);
            context.setLogLevel("WARN");
            return new SparkSweep(context);
        } catch (Exception failure) {
            if (failure instanceof SparkException || failure instanceof RuntimeException) {
                throw new BadInputException(
                        "--master " + master + ": found no Spark that starts there (" + sentence(failure)
                                + "), expected local[N], spark://HOST:7077, yarn or k8s://URL",
                        failure);
            }
            throw new IllegalStateException(failure);
        }
    }

    /** The first line of what went wrong. */
    static String sentence(Exception failure) {
        return String.valueOf(failure.getMessage()).lines().findFirst().orElse("no reason");
    }
}

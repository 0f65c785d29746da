/* Forward pass of the perceptron. */
#include "segmentation/part_net.h"

#include <math.h>
#include <stddef.h>

float dmi_part_net_run(const dmi_part_net* net, const float* features) {
    float score = net->bias;
    for (uint32_t h = 0; h < net->hidden; h++) {
        const float* weights = net->weights + (size_t)h * net->inputs;
        float sum = net->biases[h];
        for (uint32_t i = 0; i < net->inputs; i++) sum += weights[i] * features[i];
        score += net->outputs[h] * fmaxf(sum, 0);
    }
    return score;
}

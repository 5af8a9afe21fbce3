#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/int32.hpp"

namespace probe_counting
{
class Counter : public rclcpp::Node
{
public:
  explicit Counter(const rclcpp::NodeOptions & options) : Node("counter", options)
  {
    start_ = declare_parameter("start", 0);
    total_ = create_publisher<std_msgs::msg::Int32>("total", rclcpp::QoS(1).transient_local());
  }

private:
  int64_t start_;
  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr total_;
};
}  // namespace probe_counting

RCLCPP_COMPONENTS_REGISTER_NODE(probe_counting::Counter)

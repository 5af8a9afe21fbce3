#include <boost/bind.hpp>
#include <probe_talker/Reading.h>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void count(const probe_talker::Reading::ConstPtr&, int) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "counter");
  ros::NodeHandle node, own("~");
  int start;
  own.param("start", start, 0);
  ros::Publisher total = own.advertise<std_msgs::Int32>("total", 1, true);
  ros::Subscriber readings = node.subscribe<probe_talker::Reading>("reading", 5, boost::bind(count, _1, start));
  ros::spin();
}
